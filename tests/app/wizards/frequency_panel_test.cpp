#include "app/documents/frequency_file.h"
#include "app/wizards/frequency_form.h"
#include "app/wizards/frequency_panel.h"
#include "app/wizards/frequency_result_view.h"
#include "tests/app/workspaces/panel_fixture.h"
#include "widgets/controls/estimate_table.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/optional_number_edit.h"
#include "widgets/controls/progress_row.h"
#include "widgets/controls/quantity_edit.h"
#include "widgets/figure/figure_view.h"

#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QProcess>
#include <QTabWidget>
#include <QTemporaryDir>

namespace halbench::app {
namespace {

class FrequencyPanelTest : public PanelTest {
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

    template <typename Widget>
    Widget* named(const QString& accessibleName) const {
        for (auto* widget : panel.findChildren<Widget*>()) {
            if (widget->accessibleName() == accessibleName) {
                return widget;
            }
        }
        return nullptr;
    }

    void write(const QString& field, const char* value) {
        auto* box = named<widgets::QuantityEdit>(field);
        ASSERT_NE(box, nullptr) << field.toStdString();
        box->setFocus();
        QTest::keyClick(box, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(box, value);
        QTest::keyClick(box, Qt::Key_Return);
    }

    /// From 0.5 to 4 Hz in four periods: a third of the time.
    void chooseShort() {
        write("Lowest frequency", "0.5");
        write("Highest frequency", "4");
        write("Periods", "4");
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

    QTemporaryDir m_folder;
    FrequencyPanel panel{bench};
};

// Second route: the headless program with the same settings and seed.
TEST_F(FrequencyPanelTest, savesTheSameBytesAsTheBatchProgramForTheSameSeed) {
    QProcess batch;
    batch.start(HALBENCH_PROGRAM,
                {"identify", "sim:htm?seed=3", "--frequency", "--from-hz", "0.5", "--to-hz", "4", "--periods",
                 "4", "--out", path("batch.json"), "--bode", path("batch.csv")});
    connectMotor("sim:htm?seed=3", 0.0);
    chooseShort();
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Start measurement"); })) << words().toStdString();
    click(panel, "Start measurement");
    EXPECT_FALSE(isResultShown());
    ASSERT_TRUE(wait([&] { return isResultShown(); })) << message().toStdString();
    click(panel, "Save response\u2026");
    ASSERT_TRUE(wait([&] { return message().startsWith("Saved"); })) << message().toStdString();
    click(panel, "Save table\u2026");
    ASSERT_TRUE(wait([&] { return message().endsWith("response.csv"); })) << message().toStdString();
    ASSERT_TRUE(wait([&] { return batch.state() == QProcess::NotRunning; }));
    ASSERT_EQ(batch.exitCode(), 0) << batch.readAllStandardError().toStdString();
    EXPECT_EQ(content(path("response.json")), content(path("batch.json")));
    EXPECT_EQ(content(path("response.csv")), content(path("batch.csv")));
}

TEST_F(FrequencyPanelTest, showsCoherenceUnderTheBodeAndTheRawRecordOneClickAway) {
    connectMotor("sim:htm?seed=3", 0.0);
    chooseShort();
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Start measurement"); }));
    const auto before = valuesNow();
    click(panel, "Start measurement");
    ASSERT_TRUE(wait([&] { return isResultShown(); })) << message().toStdString();
    auto* tabs = named<QTabWidget>("Pictures of the frequency response");
    ASSERT_NE(tabs, nullptr);
    ASSERT_EQ(tabs->count(), 4);
    const auto* loop = static_cast<widgets::FigureView*>(tabs->widget(0));
    ASSERT_EQ(loop->figure().panels.size(), 3U);
    EXPECT_EQ(loop->figure().panels[2].y.quantity, "coherence");
    EXPECT_EQ(tabs->tabText(2), "Raw record");
    const double first_Hz = loop->figure().panels[0].curves.at(0).x.at(0);
    DisplayUnits units = bench.displayUnits();
    units.frequency = FrequencyUnit::RadiansPerSecond;
    bench.setDisplayUnits(units);
    EXPECT_EQ(loop->figure().x.unit, "rad/s");
    EXPECT_DOUBLE_EQ(loop->figure().panels[0].curves.at(0).x.at(0), 2.0 * M_PI * first_Hz);
    const auto* raw = static_cast<widgets::FigureView*>(tabs->widget(2));
    EXPECT_FALSE(raw->figure().panels.at(0).curves.at(0).x.empty());
    auto* table = panel.findChild<widgets::EstimateTable*>();
    ASSERT_GE(table->rowCount(), 2);
    EXPECT_EQ(table->item(0, 0)->text(), "phase margin");
    EXPECT_FALSE(table->text().contains("inf")) << table->text().toStdString();
    EXPECT_TRUE(words().contains("frequencies have a coherence of at least 0.900")) << words().toStdString();
    EXPECT_EQ(valuesNow(), before); // gains, windows and all else are as they were
    EXPECT_FALSE(bench.session().report().board.isArmed);
    FrequencyResult used;
    QObject::connect(&panel, &FrequencyPanel::useRequested,
                     [&used](const FrequencyResult& result) { used = result; });
    click(panel, "Use in Tune");
    EXPECT_FALSE(used.points.empty());
    click(panel, "Measure again");
    EXPECT_NE(button(panel, "Start measurement"), nullptr);
}

TEST_F(FrequencyPanelTest, saysBeforehandWhatMovesAndNeedsADeviceToMoveIt) {
    EXPECT_FALSE(isEnabled(panel, "Start measurement"));
    connectMotor("sim:htm", 0.0);
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Start measurement"); }));
    // The base of 5 rad/s is raised to where 8 s hold 6.382 turns... 2 pi 6.382/8 = 5.01 rad/s, or the next
    EXPECT_TRUE(words().contains("The rotor will turn forward at 5.")) << words().toStdString();
    EXPECT_TRUE(words().contains("The speed keeps its sign"));
    EXPECT_TRUE(words().contains("Maximum current 3.")); // of 4 A
    write("Base speed", "-6");
    EXPECT_TRUE(words().contains("turn in reverse")) << words().toStdString();
    bench.session().disconnectDevice();
    EXPECT_FALSE(isEnabled(panel, "Start measurement"));
}

TEST_F(FrequencyPanelTest, whatWouldTurnFrictionAroundCannotBeStarted) {
    connectMotor("sim:htm", 0.0);
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Start measurement"); }));
    write("Base speed", "2");
    EXPECT_FALSE(isEnabled(panel, "Start measurement"));
    EXPECT_TRUE(words().contains("at least 3 rad/s in either direction")) << words().toStdString();
    write("Base speed", "5");
    EXPECT_TRUE(isEnabled(panel, "Start measurement"));
    auto* amplitude = panel.findChild<widgets::OptionalNumberEdit*>("amplitude");
    amplitude->setFocus();
    QTest::keyClicks(amplitude, "30");
    EXPECT_FALSE(isEnabled(panel, "Start measurement"));
    EXPECT_TRUE(words().contains("change its sign")) << words().toStdString();
    QTest::keyClick(amplitude, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(amplitude, "abc");
    EXPECT_FALSE(isEnabled(panel, "Start measurement"));
    QTest::keyClick(amplitude, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClick(amplitude, Qt::Key_Delete);
    EXPECT_TRUE(isEnabled(panel, "Start measurement"));
    write("Highest frequency", "60"); // beyond 45 % of the loop's 100 Hz
    EXPECT_FALSE(isEnabled(panel, "Start measurement"));
}

TEST_F(FrequencyPanelTest, cancellingRestoresEverythingAndSaysSo) {
    connectMotor("sim:htm", 20.0);
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Start measurement"); }));
    const auto before = valuesNow();
    panel.findChild<FrequencyForm*>()->setFocus();
    QTest::keyClick(named<QComboBox>("Excitation"), Qt::Key_Return, Qt::ControlModifier); // Ctrl+Return
    ASSERT_TRUE(wait([&] { return bench.session().report().board.isArmed; }));
    click(panel, "Cancel");
    ASSERT_TRUE(wait([&] { return message().contains("cancelled"); })) << message().toStdString();
    EXPECT_TRUE(wait([&] { return !bench.session().report().board.isArmed; }));
    EXPECT_EQ(valuesNow(), before);
    EXPECT_NE(button(panel, "Start measurement"), nullptr);
}

TEST_F(FrequencyPanelTest, everyExcitationCanBeChosenByKeyboardAndIsPlannedWithItsTime) {
    connectMotor("sim:htm", 0.0);
    auto* choice = named<QComboBox>("Excitation");
    ASSERT_NE(choice, nullptr);
    QStringList outlooks;
    for (int i = 0; i < choice->count(); ++i) {
        outlooks << words();
        choice->setFocus();
        QTest::keyClick(choice, Qt::Key_Down);
    }
    EXPECT_EQ(choice->currentData().toInt(), static_cast<int>(Excitation::Chirp));
    outlooks.removeDuplicates();
    EXPECT_EQ(outlooks.size(), 3); // each takes another time
}

} // namespace
} // namespace halbench::app
