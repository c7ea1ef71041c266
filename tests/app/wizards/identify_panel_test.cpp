#include "app/wizards/identify_form.h"
#include "app/wizards/identify_panel.h"
#include "app/workbench/shared_results.h"
#include "app/workbench/wall_clock.h"
#include "app/workspaces/device/pace_row.h"
#include "app/workspaces/parts/preflight.h"
#include "tests/app/workspaces/panel_fixture.h"
#include "widgets/controls/estimate_table.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/optional_number_edit.h"
#include "widgets/controls/progress_row.h"
#include "widgets/controls/quantity_edit.h"
#include "widgets/controls/step_list.h"
#include "widgets/figure/figure_view.h"
#include "widgets/theme/theme_style.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QProcess>
#include <QSplitter>
#include <QTemporaryDir>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

class IdentifyPanelTest : public PanelTest {
protected:
    void SetUp() override {
        PanelTest::SetUp();
        panel.setFileChooser({[this](QWidget*, const FileQuestion&) { return path("panel.json"); },
                              [this](QWidget*, const FileQuestion&) { return m_toOpen; }});
        show(panel);
    }

    QString path(const char* name) const { return m_folder.filePath(name); }

    static QByteArray content(const QString& path) {
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
        return file.readAll();
    }

    template <typename Widget>
    Widget* child(const QString& name = {}) const {
        return panel.findChild<Widget*>(name);
    }

    void give(const char* symbol, const char* value) {
        auto* edit = child<widgets::OptionalNumberEdit>(symbol);
        edit->setFocus();
        QTest::keyClick(edit, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClick(edit, Qt::Key_Delete);
        QTest::keyClicks(edit, value);
    }

    /// From 2 A to 4 A in three steps: enough for a result, a third of the time.
    void chooseShortSweep() {
        const char* values[] = {"2", "4", "1"};
        const auto boxes = panel.findChildren<QDoubleSpinBox*>();
        for (int i = 0; i < 3; ++i) {
            boxes[i]->setFocus();
            QTest::keyClick(boxes[i], Qt::Key_A, Qt::ControlModifier);
            QTest::keyClicks(boxes[i], values[i]);
            QTest::keyClick(boxes[i], Qt::Key_Return);
            ASSERT_EQ(boxes[i]->value(), QString(values[i]).toDouble());
        }
    }

    /// Into the field of a current: from, to, step. It is not entered by that.
    void type(std::size_t field, const char* text) {
        auto* edit = panel.findChildren<widgets::QuantityEdit*>().at(static_cast<int>(field));
        edit->setFocus();
        QTest::keyClick(edit, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(edit, text);
    }

    bool hasLabel(const QString& words) const {
        const auto all = panel.findChildren<QLabel*>();
        return std::any_of(all.begin(), all.end(), [&words](const QLabel* label) {
            return label->isVisible() && label->text().contains(words);
        });
    }

    QString message() const { return child<widgets::MessageBar>()->message().text; }
    bool isResultShown() const { return button(panel, "Identify again") != nullptr; }

    QTemporaryDir m_folder;
    QString m_toOpen;
    IdentifyPanel panel{bench};
};

TEST_F(IdentifyPanelTest, savesTheSameBytesAsTheBatchProgramForTheSameSeed) {
    // Second route: the headless program, with all imperfections of the motor.
    QProcess batch;
    batch.start(HALBENCH_PROGRAM,
                {"identify", "sim:htm?seed=3", "--given", "J=5.5e-4", "--out", path("batch.json")});
    connectMotor("sim:htm?seed=3", 0.0);
    give("J", "5.5e-4");
    click(panel, "Start identification");
    EXPECT_FALSE(isResultShown());
    ASSERT_TRUE(wait([&] { return isResultShown(); })) << message().toStdString();
    EXPECT_FALSE(child<widgets::EstimateTable>()->item(0, 1)->text().isEmpty());
    click(panel, "Save as model\u2026");
    ASSERT_TRUE(wait([&] { return message().startsWith("Saved"); })) << message().toStdString();
    ASSERT_TRUE(wait([&] { return batch.state() == QProcess::NotRunning; }));
    ASSERT_EQ(batch.exitCode(), 0) << batch.readAllStandardError().toStdString();
    EXPECT_EQ(content(path("panel.json")), content(path("batch.json")));
    ASSERT_TRUE(bench.identification());
    EXPECT_TRUE(isEnabled(panel, "Tune with this model"));
}

TEST_F(IdentifyPanelTest, saysWhatWillMoveAndNeedsADeviceToMoveIt) {
    EXPECT_FALSE(isEnabled(panel, "Start identification"));
    connectMotor("sim:htm", 0.0);
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Start identification"); }));
    QString text;
    for (const auto* label : panel.findChildren<QLabel*>()) {
        text += label->text() + '\n';
    }
    // (phi 4 A - K_f)/c of the published motor: 29.8 rad/s (htm-theory.md section 2)
    EXPECT_TRUE(text.contains("at up to 285 r/min")) << text.toStdString();
    EXPECT_TRUE(text.contains("Maximum current 4.0 A"));
    EXPECT_TRUE(text.contains("Coils 25 \u00b0C now"));
    bench.session().disconnectDevice();
    EXPECT_FALSE(isEnabled(panel, "Start identification"));
}

TEST_F(IdentifyPanelTest, aNumberThatIsNoneKeepsItFromStarting) {
    connectMotor("sim:htm", 0.0);
    for (const char* wrong : {"nan", "inf", "0", "-1", "abc"}) {
        give("J", wrong);
        EXPECT_FALSE(isEnabled(panel, "Start identification")) << wrong;
    }
    give("J", "5.5e-4");
    EXPECT_TRUE(wait([&] { return isEnabled(panel, "Start identification"); }));
}

TEST_F(IdentifyPanelTest, aCurrentThatIsNoneKeepsItFromStartingWhileItIsShown) {
    connectMotor("sim:htm", 0.0);
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Start identification"); }));
    auto* last = panel.findChildren<widgets::QuantityEdit*>().at(1);
    const double before_A = last->value();
    for (const char* wrong : {"abc", "nan", "99", "0", "1..2"}) {
        type(1, wrong);
        EXPECT_FALSE(isEnabled(panel, "Start identification")) << wrong;
        QTest::keyClick(&panel, Qt::Key_Return, Qt::ControlModifier); // would start it
        EXPECT_TRUE(bench.session().procedure().isEmpty()) << wrong;
        EXPECT_TRUE(hasLabel("To current: ")) << wrong;
        button(panel, "Advanced")->setFocus(); // the field has its number back, and says that it does
        EXPECT_EQ(last->value(), before_A) << wrong;
        EXPECT_FALSE(isEnabled(panel, "Start identification")) << "the click that takes the focus: " << wrong;
        EXPECT_TRUE(wait([&] { return isEnabled(panel, "Start identification"); })) << wrong;
        EXPECT_TRUE(hasLabel("To current: '" + QString(wrong) + "' is not valid. ")) << wrong;
        EXPECT_TRUE(hasLabel(" Reset to 4.00 A.")) << wrong;
        type(1, "3"); // not entered yet, but it is what is shown
        EXPECT_FALSE(hasLabel("is not valid")) << wrong;
        EXPECT_TRUE(hasLabel("Maximum current 3.0 A")) << wrong;
        type(1, "4");
        QTest::keyClick(last, Qt::Key_Return);
    }
}

TEST_F(IdentifyPanelTest, everyFieldThatIsWrongIsNamed) {
    connectMotor("sim:htm", 0.0);
    type(0, "9");
    type(2, "0"); // leaves the first one: it has its number back
    give("J", "x");
    give("c", "-1");
    EXPECT_FALSE(isEnabled(panel, "Start identification"));
    EXPECT_TRUE(hasLabel("Given inertia J: "));
    EXPECT_TRUE(hasLabel("Given damping c: "));
    EXPECT_FALSE(hasLabel("Step: ")) << "it shows a good number";
    type(2, "0");
    EXPECT_TRUE(hasLabel("Step: Allowed: 0.05 to 4.00. \u2192 Correct the number\nGiven inertia J: "));
    EXPECT_TRUE(hasLabel("Given damping c: "));
    give("J", "");
    give("c", "");
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Start identification"); }));
}

TEST_F(IdentifyPanelTest, aSweepThatEndsBelowItsStartIsMarkedAndSaid) {
    connectMotor("sim:htm", 0.0);
    auto* last = panel.findChildren<widgets::QuantityEdit*>().at(1);
    type(1, "1");
    QTest::keyClick(last, Qt::Key_Return);
    button(panel, "Advanced")->setFocus();
    EXPECT_EQ(widgets::roleOf(*last), widgets::Role::Bad);
    EXPECT_TRUE(hasLabel("To current: Smaller than \"From current\"."));
    EXPECT_FALSE(isEnabled(panel, "Start identification"));
    type(0, "0.5");
    QTest::keyClick(last, Qt::Key_Tab);
    EXPECT_EQ(widgets::roleOf(*last), widgets::Role::None);
    EXPECT_TRUE(wait([&] { return isEnabled(panel, "Start identification"); }));
}

TEST_F(IdentifyPanelTest, withoutAGivenConstantItSaysWhatWouldSupplyTheScale) {
    connectMotor("sim:htm", 0.0);
    chooseShortSweep();
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Start identification"); }));
    QTest::keyClick(&panel, Qt::Key_Return, Qt::ControlModifier);
    ASSERT_TRUE(wait([&] { return isResultShown(); })) << message().toStdString();
    const auto* table = child<widgets::EstimateTable>();
    EXPECT_EQ(table->item(3, 4)->text(), "not identifiable");
    EXPECT_EQ(table->item(3, 1)->text(), "\u2013");
    bool isSaid = false;
    for (const auto* label : panel.findChildren<QLabel*>()) {
        isSaid = isSaid || (label->isVisible() && label->text().contains("Not identifiable: J"));
    }
    EXPECT_TRUE(isSaid);
    EXPECT_TRUE(isEnabled(panel, "Tune with this model")); // the quotients are enough
}

TEST_F(IdentifyPanelTest, aResultCarriesTheWallClocksStartAndTheDevicesDuration) {
    QDateTime now = QDateTime::fromString("2026-05-04T03:02:01Z", Qt::ISODate);
    bench.setWallClock([&now] { return now; });
    connectMotor("sim:htm", 50.0);
    chooseShortSweep();
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Start identification"); }));
    click(panel, "Start identification");
    now = now.addSecs(3600); // it begins when it is started, not when it ends
    ASSERT_TRUE(wait([&] { return isResultShown(); })) << message().toStdString();
    const auto all = bench.history().range("reference").value_or(control::TimeRange{});
    EXPECT_GT(all.length_s(), 30.0);
    std::vector<control::TimedValue> shown;
    bench.history().samples("reference", all, shown);
    EXPECT_FALSE(shown.empty());
    EXPECT_TRUE(std::all_of(shown.begin(), shown.end(), [](const auto& one) {
        return std::isnan(one.value);
    })) << "4 A would be drawn as 229 degrees";
    EXPECT_EQ(bench.provenance().header.started, "2026-05-04T03:02:01Z");
    EXPECT_GT(bench.identification()->duration_s, 30.0); // eight coast-downs each way alone take longer
    bool isSaid = false;
    for (const auto* label : panel.findChildren<QLabel*>()) {
        isSaid = isSaid || (label->text().contains("started " + localDate("2026-05-04T03:02:01Z")) &&
                            label->text().contains("minutes of device time"));
    }
    EXPECT_TRUE(isSaid);
    // The page was never shown before; still the numbers have their place beside the pictures.
    const int needed_px = child<widgets::EstimateTable>()->neededWidth();
    const auto* splitter = child<QSplitter>();
    EXPECT_GE(splitter->sizes().at(0), std::min(needed_px, splitter->width() * 2 / 5));
}

TEST_F(IdentifyPanelTest, aResultOfTheProjectSaysWhetherItsDeviceIsTheOneThatIsConnected) {
    IdentifyResult result;
    result.quality.verdict = Verdict::Good;
    ResultHeader header;
    header.started = "2026-05-04T03:02:01Z";
    header.device = devices::DeviceInfo{"", "htm", "htm-0042", "FW", "", false, {}};
    bench.setIdentification(result, {header, ResultOrigin::Project});
    EXPECT_TRUE(message().contains("No device is connected")) << message().toStdString();
    connectMotor("sim:htm", 0.0);
    EXPECT_TRUE(message().contains(localDate("2026-05-04T03:02:01Z"))) << message().toStdString();
    EXPECT_TRUE(message().contains("Another device is connected: ")) << message().toStdString();
    header.device = bench.session().info();
    bench.setIdentification(result, {header, ResultOrigin::Project});
    EXPECT_TRUE(message().contains("Same as the connected device.")) << message().toStdString();
}

// A small screen, with as much said above as there is after a sweep that was cancelled.
TEST_F(IdentifyPanelTest, whatStartsAndEndsItIsInSightHoweverLittleRoomThereIs) {
    panel.resize(700, 330);
    connectMotor("sim:htm", 1.0);
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Start identification"); }));
    click(panel, "Start identification");
    EXPECT_TRUE(isWhole(panel, "Cancel"));
    click(panel, "Cancel");
    ASSERT_TRUE(wait([&] { return message().contains("cancelled"); })) << message().toStdString();
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Start identification"); }));
    EXPECT_TRUE(isWhole(panel, "Start identification"));
    auto* pace = child<PaceRow>();
    EXPECT_EQ(pace->visibleRegion(), QRegion(pace->rect()));
}

TEST_F(IdentifyPanelTest, theGivenConstantsAreKeptAndComeBack) {
    give("J", "5.5e-4");
    give("phi", "abc");
    EXPECT_EQ(panel.given(), (std::map<std::string, double>{{"J", 5.5e-4}}));
    panel.setGiven({{"c", 0.0}, {"phi", 0.0143}});
    EXPECT_EQ(panel.given(), (std::map<std::string, double>{{"c", 0.0}, {"phi", 0.0143}}));
    EXPECT_TRUE(child<widgets::OptionalNumberEdit>("J")->text().isEmpty());
}

TEST_F(IdentifyPanelTest, showsThePlateausWhileTheyAreMeasured) {
    connectMotor("sim:htm", 0.0);
    std::size_t most = 0;
    widgets::FigureView* live = nullptr;
    click(panel, "Start identification");
    ASSERT_TRUE(wait([&] {
        for (auto* view : panel.findChildren<widgets::FigureView*>()) {
            live = view->isVisible() ? view : live;
        }
        if (!isResultShown() && live != nullptr && !live->isEmpty()) {
            most = std::max(most, live->figure().panels.at(0).curves.back().x.size());
        }
        return isResultShown();
    }));
    EXPECT_GT(most, 3U);
}

TEST_F(IdentifyPanelTest, cancelInEachStageRestoresEverything) {
    connectMotor("sim:htm", 0.0);
    chooseShortSweep();
    const auto before = valuesNow();
    for (const ProcedureState stage : {ProcedureState::Prepare, ProcedureState::Excite,
                                       ProcedureState::Record, ProcedureState::Fit, ProcedureState::Judge}) {
        ASSERT_TRUE(wait([&] { return isEnabled(panel, "Start identification"); }));
        // At this pace the motion lasts longer than the word needs; the computing behind it need not.
        const bool isComputing = stage == ProcedureState::Fit || stage == ProcedureState::Judge;
        bench.session().setPace({isComputing ? 0.0 : 5.0});
        bool isCancelled = false;
        const auto connection = QObject::connect(
            &bench.session(), &DeviceSession::procedureStage, &panel, [&](ProcedureState now) {
                if (now == stage && button(panel, "Cancel") != nullptr) {
                    QTest::mouseClick(button(panel, "Cancel"), Qt::LeftButton);
                    isCancelled = true;
                }
            });
        click(panel, "Start identification");
        ASSERT_TRUE(wait([&] { return bench.session().procedure().isEmpty() && !button(panel, "Cancel"); }));
        QObject::disconnect(connection);
        bench.session().setPace({0.0});
        EXPECT_TRUE(isCancelled) << procedureStateName(stage);
        EXPECT_EQ(valuesNow(), before) << procedureStateName(stage);
        EXPECT_FALSE(bench.session().report().board.isArmed);
        if (isResultShown()) { // it was over before the word arrived
            EXPECT_TRUE(isComputing) << procedureStateName(stage);
            click(panel, "Identify again");
        } else {
            EXPECT_TRUE(message().contains("cancelled")) << message().toStdString();
        }
    }
}

TEST_F(IdentifyPanelTest, aDeviceLostMidWayIsSaidInPlaceAndThePanelStaysUsable) {
    QProcess board;
    board.start(HALBENCH_PROGRAM, {"serve", "sim:htm", "--tcp", "127.0.0.1:0"});
    ASSERT_TRUE(board.waitForReadyRead(Patience_ms));
    const QString address = QString::fromUtf8(board.readLine()).trimmed().section(' ', 1);
    connectMotor(address, 1.0);
    ASSERT_TRUE(wait([&] { return child<Preflight>()->temperature_degC().has_value(); }));
    if (auto* consent = child<QCheckBox>(); consent->isVisible()) {
        EXPECT_FALSE(isEnabled(panel, "Start identification")); // a real motor moves only with consent
        QTest::mouseClick(consent, Qt::LeftButton, {}, {8, consent->height() / 2});
    }
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Start identification"); }));
    click(panel, "Start identification");
    ASSERT_TRUE(wait([&] { return bench.session().report().board.isArmed; }));
    board.kill();
    ASSERT_TRUE(
        wait([&] { return bench.session().state() == SessionState::Reconnecting && !message().isEmpty(); }));
    EXPECT_TRUE(bench.session().procedure().isEmpty());
    EXPECT_TRUE(message().contains("connection to the device lost")) << message().toStdString();
    EXPECT_TRUE(child<widgets::MessageBar>()->message().remedy.contains("watchdog disarms it"));
    EXPECT_FALSE(isEnabled(panel, "Start identification"));
    EXPECT_NE(button(panel, "Start identification"), nullptr);
    bench.session().disconnectDevice();
    connectMotor("sim:htm", 0.0); // another device, and on it goes
    EXPECT_TRUE(message().contains("lost")) << "still there to be read: " << message().toStdString();
    EXPECT_TRUE(wait([&] { return isEnabled(panel, "Start identification"); }));
    board.waitForFinished(Patience_ms);
}

TEST_F(IdentifyPanelTest, disconnectingWhileItRunsSaysWhyItEnded) {
    connectMotor("sim:htm", 1.0);
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Start identification"); }));
    click(panel, "Start identification");
    ASSERT_TRUE(wait([&] { return bench.session().report().board.isArmed; }));
    bench.session().disconnectDevice();
    ASSERT_TRUE(wait([&] { return bench.session().state() == SessionState::Disconnected; }));
    EXPECT_TRUE(message().contains("Stopped: the device was disconnected")) << message().toStdString();
    const QString remedy = child<widgets::MessageBar>()->message().remedy;
    EXPECT_TRUE(remedy.contains("disarmed")) << remedy.toStdString();
    connectMotor("sim:htm", 0.0);
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Start identification"); }));
    EXPECT_TRUE(message().contains("Stopped: the device was disconnected")) << "until the next one starts";
    click(panel, "Start identification");
    EXPECT_TRUE(message().isEmpty());
    ASSERT_TRUE(wait([&] { return !bench.session().procedure().isEmpty(); }));
}

TEST_F(IdentifyPanelTest, aModelThatIsDamagedIsRefusedInPlace) {
    m_toOpen = path("damaged.json");
    QFile file(m_toOpen);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("{\"schema\": \"halbench.identification/2\"}");
    file.close();
    click(panel, "Load model\u2026");
    ASSERT_TRUE(wait([&] { return message().contains("damaged.json"); }));
    EXPECT_FALSE(isResultShown());
    EXPECT_FALSE(bench.identification());
}

// What the field says is the tolerance that a run is made with; one that no drive has starts none.
TEST_F(IdentifyPanelTest, theCurrentToleranceOfTheFieldIsTheOneOfTheRun) {
    for (auto* button : panel.findChildren<QToolButton*>()) {
        if (button->accessibleName() == "Advanced settings") {
            button->click();
        }
    }
    ASSERT_TRUE(child<widgets::OptionalNumberEdit>("currentTolerance")->isVisible());
    give("currentTolerance", "60");
    EXPECT_FALSE(child<IdentifyForm>()->config());
    give("currentTolerance", "4");
    const auto config = child<IdentifyForm>()->config();
    ASSERT_TRUE(config);
    EXPECT_EQ(config->currentTolerance_percent, 4.0);
}

} // namespace
} // namespace halbench::app
