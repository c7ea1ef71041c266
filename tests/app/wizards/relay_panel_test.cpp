#include "app/documents/relay_document.h"
#include "app/wizards/relay_form.h"
#include "app/wizards/relay_panel.h"
#include "tests/app/workspaces/panel_fixture.h"
#include "widgets/controls/estimate_table.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/optional_number_edit.h"
#include "widgets/figure/figure_view.h"

#include <QFile>
#include <QLabel>
#include <QProcess>
#include <QTemporaryDir>

namespace halbench::app {
namespace {

class RelayPanelTest : public PanelTest {
protected:
    void SetUp() override {
        PanelTest::SetUp();
        panel.setFileChooser({[this](QWidget*, const FileQuestion& question) {
                                  return path(question.suggestedName.toUtf8().constData());
                              },
                              {}});
        show(panel);
    }

    QString path(const char* name) const { return m_folder.filePath(name); }

    static QByteArray content(const QString& path) {
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
        return file.readAll();
    }

    void write(const QString& field, const char* value) {
        for (auto* edit : panel.findChildren<widgets::OptionalNumberEdit*>()) {
            if (edit->accessibleName() == field) {
                edit->setFocus();
                QTest::keyClick(edit, Qt::Key_A, Qt::ControlModifier);
                QTest::keyClick(edit, Qt::Key_Delete);
                QTest::keyClicks(edit, value);
            }
        }
    }

    QString words() const {
        QString text;
        for (const auto* label : panel.findChildren<QLabel*>()) {
            text += label->text() + '\n';
        }
        return text;
    }
    QString message() const { return panel.findChild<widgets::MessageBar*>()->message().text; }
    bool isResultShown() const { return button(panel, "Measure again") != nullptr; }
    void measure() {
        ASSERT_TRUE(wait([&] { return isEnabled(panel, "Start experiment"); })) << words().toStdString();
        click(panel, "Start experiment");
        ASSERT_TRUE(wait([&] { return isResultShown(); })) << message().toStdString();
    }

    QTemporaryDir m_folder;
    RelayPanel panel{bench};
};

// Its plan takes a tenth of a second, which a user of other panels does not wait for.
TEST_F(RelayPanelTest, aHiddenPanelPlansWhenItIsShown) {
    RelayPanel hidden{bench};
    const auto planned = [&hidden] {
        const auto labels = hidden.findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
            return label->text().contains(QStringLiteral("Maximum current"));
        });
    };
    connectMotor("sim:htm?imperfections=off", 0.0);
    EXPECT_FALSE(planned());
    EXPECT_FALSE(isEnabled(hidden, "Start experiment"));
    show(hidden);
    EXPECT_TRUE(planned());
}

// Second route: the headless program with the same settings and seed.
TEST_F(RelayPanelTest, savesTheSameBytesAsTheBatchProgram) {
    QProcess batch;
    batch.start(HALBENCH_PROGRAM, {"identify", "sim:htm?imperfections=off", "--relay", "--cycles", "60",
                                   "--out", path("batch.json")});
    connectMotor("sim:htm?imperfections=off", 0.0);
    write("Cycles", "60");
    measure();
    click(panel, "Save result\u2026");
    ASSERT_TRUE(wait([&] { return message().startsWith("Saved"); })) << message().toStdString();
    ASSERT_TRUE(wait([&] { return batch.state() == QProcess::NotRunning; }));
    ASSERT_EQ(batch.exitCode(), 0) << batch.readAllStandardError().toStdString();
    EXPECT_EQ(content(path("relay.json")), content(path("batch.json")));
}

TEST_F(RelayPanelTest, showsTheUltimateGainInWordsAndHandsItToTune) {
    connectMotor("sim:htm?imperfections=off", 0.0);
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Start experiment"); }));
    const auto before = valuesNow();
    measure();
    auto* table = panel.findChild<widgets::EstimateTable*>();
    ASSERT_EQ(table->rowCount(), 4);
    EXPECT_EQ(table->item(0, 0)->text(), "ultimate gain");
    EXPECT_TRUE(table->text().contains("published motor")) << table->text().toStdString();
    EXPECT_TRUE(words().contains("cycles of")) << words().toStdString();
    EXPECT_TRUE(words().contains("Identify the motor"));
    EXPECT_FALSE(panel.findChild<widgets::FigureView*>()->figure().panels.at(0).curves.at(0).x.empty());
    EXPECT_EQ(valuesNow(), before); // gains, limits, windows and all else are as they were
    EXPECT_FALSE(bench.session().report().board.isArmed);
    double gain = 0.0;
    double period_s = 0.0;
    QObject::connect(&panel, &RelayPanel::useRequested, [&](double g, double t) {
        gain = g;
        period_s = t;
    });
    click(panel, "Use in Tune");
    EXPECT_NEAR(gain, 16.29, 0.5); // with the amplifier's lag (resources/help/htm-theory.md 7.7)
    EXPECT_NEAR(period_s, 0.307, 0.005);
    click(panel, "Measure again");
    EXPECT_NE(button(panel, "Start experiment"), nullptr);
}

// Sensors that nobody calibrated drive the swing: no number is shown, and what helps is said.
TEST_F(RelayPanelTest, aRefusedResultHasNoNumberAndCannotBeUsed) {
    connectMotor("sim:htm?seed=1", 0.0);
    measure();
    EXPECT_FALSE(isEnabled(panel, "Use in Tune"));
    EXPECT_TRUE(words().contains("calibrate the sensors", Qt::CaseInsensitive)) << words().toStdString();
    EXPECT_EQ(panel.findChild<widgets::EstimateTable*>()->rowCount(), 3); // no phase
}

TEST_F(RelayPanelTest, saysBeforehandWhatMovesAndRefusesWhatCannotBeDoneSafely) {
    EXPECT_FALSE(isEnabled(panel, "Start experiment"));
    connectMotor("sim:htm", 0.0);
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Start experiment"); }));
    EXPECT_TRUE(words().contains("The rotor will turn forward at 6.0")) << words().toStdString();
    EXPECT_TRUE(words().contains("The speed keeps its sign"));
    EXPECT_TRUE(words().contains("Maximum current 3.2")) << words().toStdString();
    write("Base speed", "-7");
    EXPECT_TRUE(words().contains("turn in reverse")) << words().toStdString();
    write("Base speed", "2");
    EXPECT_FALSE(isEnabled(panel, "Start experiment"));
    write("Base speed", "");
    EXPECT_TRUE(isEnabled(panel, "Start experiment"));
    write("Relay amplitude", "1"); // less than friction needs
    EXPECT_FALSE(isEnabled(panel, "Start experiment"));
    EXPECT_TRUE(words().contains("standstill")) << words().toStdString();
    write("Relay amplitude", "abc");
    EXPECT_FALSE(isEnabled(panel, "Start experiment"));
    write("Relay amplitude", "");
    EXPECT_TRUE(isEnabled(panel, "Start experiment"));
    bench.session().disconnectDevice();
    EXPECT_FALSE(isEnabled(panel, "Start experiment"));
}

TEST_F(RelayPanelTest, cancellingRestoresEverythingAndSaysSo) {
    connectMotor("sim:htm", 20.0);
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Start experiment"); }));
    const auto before = valuesNow();
    QTest::keyClick(panel.findChild<widgets::OptionalNumberEdit*>(), Qt::Key_Return, Qt::ControlModifier);
    ASSERT_TRUE(wait([&] { return bench.session().report().board.isArmed; }));
    click(panel, "Cancel");
    ASSERT_TRUE(wait([&] { return message().contains("cancelled"); })) << message().toStdString();
    EXPECT_TRUE(wait([&] { return !bench.session().report().board.isArmed; }));
    EXPECT_EQ(valuesNow(), before);
    EXPECT_NE(button(panel, "Start experiment"), nullptr);
}

} // namespace
} // namespace halbench::app
