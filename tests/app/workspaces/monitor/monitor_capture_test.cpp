#include "app/workbench/drive_control.h"
#include "app/workspaces/monitor/trigger_bar.h"
#include "app/workspaces/recordings/record_panel.h"
#include "devices/formats/recording_file.h"
#include "tests/app/workspaces/monitor/monitor_fixture.h"
#include "widgets/controls/elided_label.h"
#include "widgets/controls/quantity_edit.h"

#include <QAction>
#include <QComboBox>
#include <QLineEdit>
#include <QStandardItemModel>
#include <QTemporaryDir>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace halbench::app {
namespace {

constexpr std::size_t Rows = 4096;

/// The board's own capture through the Monitor's widgets, with a motor whose noise makes every stretch
/// unmistakable.
class MonitorCaptureTest : public MonitorTest {
protected:
    void SetUp() override {
        MonitorTest::SetUp();
        MonitorView view;
        view.plots = {{{"hall.a", "hall.b"}, {}, {}}, {{"speed"}, {}, {}}, {{"current_command"}, {}, {}}};
        panel->setView(view);
        connectTo("sim:htm?seed=5&hall_noise_mT=2", 10.0);
        ASSERT_TRUE(wait([&] { return bench().history().contains("hall.a"); }));
    }

    TriggerBar& bar() { return *panel->findChild<TriggerBar*>(); }
    widgets::ElidedLabel& stateLabel() { return *find<widgets::ElidedLabel>(*panel, "State of the trigger"); }
    QString state() { return stateLabel().accessibleDescription(); }
    QString words() { return stateLabel().words(); }
    QComboBox& box(const QString& name) { return *find<QComboBox>(*panel, name); }
    void choose(const QString& name, const QString& text) {
        ASSERT_GE(box(name).findText(text), 0) << text.toStdString();
        box(name).setCurrentIndex(box(name).findText(text));
        Q_EMIT box(name).activated(box(name).currentIndex());
    }
    void enter(const QString& field, const QString& text) {
        auto* found = find<widgets::QuantityEdit>(*panel, field);
        type(found, text);
        QTest::keyClick(found, Qt::Key_Return);
    }
    bool isOffered(const QString& name, const QString& text) {
        const auto* items = qobject_cast<QStandardItemModel*>(box(name).model());
        return items->item(box(name).findText(text))->isEnabled();
    }
    /// Single, on the board, Hall A rising through the middle of its noise.
    void captureHall() {
        press(Qt::Key_T);
        choose("Mode", "Single");
        choose("Source", "Hall A");
        ASSERT_TRUE(wait([&] { return bench().history().range("hall.a")->length_s() > 1.0; }));
        click(*panel, "Set level to 50 %");
        choose("Event in", "Board");
    }
    std::vector<double> shown(const std::string& signal) {
        std::vector<control::TimedValue> samples;
        stack().history()->samples(signal, {-10.0, 10.0}, samples);
        std::vector<double> values;
        for (const control::TimedValue& sample : samples) {
            values.push_back(sample.value);
        }
        return values;
    }
    std::vector<double> streamed(const std::string& signal) {
        std::vector<control::TimedValue> samples;
        bench().history().samples(signal, *bench().history().range(), samples);
        std::vector<double> values;
        for (const control::TimedValue& sample : samples) {
            values.push_back(sample.value);
        }
        return values;
    }
};

// The second route: the same rows came through the stream of the same board at the same rate, with the rows
// one after the other, so that time and values are both compared.
TEST_F(MonitorCaptureTest, showsTheRowsOfTheLoopWithZeroAtTheEvent) {
    captureHall();
    const double level = bar().choice().level;
    ASSERT_TRUE(wait([&] { return state().startsWith("Stopped after an event"); })) << state().toStdString();
    ASSERT_NE(stack().history(), &bench().history());
    const auto range = *stack().history()->range();
    EXPECT_NEAR(range.begin_s, -1.024, 1e-12); // a quarter of 4096 rows of 1 ms
    EXPECT_NEAR(range.end_s, 3.071, 1e-12);
    EXPECT_NEAR(stack().timeRange().begin_s, -0.25, 1e-9); // of the window of 1 s
    EXPECT_NEAR(stack().timeRange().end_s, 0.75, 1e-9);
    const std::vector<double> hall = shown("hall.a");
    ASSERT_EQ(hall.size(), Rows);
    EXPECT_LT(hall[Rows / 4 - 1], level);
    EXPECT_GE(hall[Rows / 4], level);
    EXPECT_EQ(stack().history()->unit("hall.a"), "T");
    // Both numbers are of single precision.
    const auto isSame = [](double one, double other) {
        return std::fabs(one - other) <= 2.4e-7 * std::fabs(other);
    };
    for (const char* signal : {"hall.a", "hall.b"}) {
        const std::vector<double> caught = shown(signal);
        const std::vector<double> stream = streamed(signal);
        EXPECT_NE(std::search(stream.begin(), stream.end(), caught.begin(), caught.end(), isSame),
                  stream.end())
            << signal;
    }
    EXPECT_FALSE(bench().session().report().board.isArmed);
}

TEST_F(MonitorCaptureTest, putsTheBoardsSetUpBackAndShowsTheLiveSamplesAgain) {
    captureHall();
    ASSERT_TRUE(wait([&] { return state().startsWith("Stopped after an event"); })) << state().toStdString();
    EXPECT_EQ(parameter("capture.pretrigger"), 1024.0);
    press(Qt::Key_End);
    EXPECT_FALSE(bar().isVisible());
    EXPECT_EQ(stack().history(), &bench().history());
    EXPECT_TRUE(stack().isFollowing());
    EXPECT_EQ(parameter("capture.pretrigger"), 0.0);
    EXPECT_EQ(parameter("capture.start"), 0.0);
    EXPECT_EQ(parameter("capture.signal_1"), 255.0);
}

TEST_F(MonitorCaptureTest, offersOnlyWhatTheBoardCanDoAndSaysWhy) {
    press(Qt::Key_T);
    choose("Source", "Hall A");
    choose("Slope", "either");
    choose("Event in", "Board");
    EXPECT_EQ(box("Mode").currentText(), "Normal"); // it was Auto
    EXPECT_FALSE(isOffered("Mode", "Auto"));
    EXPECT_FALSE(isOffered("Slope", "either"));
    EXPECT_EQ(box("Slope").currentText(), "rising");
    for (const char* field : {"Hysteresis", "Hold-off"}) {
        auto* number = find<widgets::QuantityEdit>(*panel, field);
        EXPECT_FALSE(number->isEnabled()) << field;
        EXPECT_TRUE(number->toolTip().startsWith("The device has no")) << field;
    }
    choose("Event in", "Live");
    EXPECT_TRUE(isOffered("Mode", "Auto"));
    EXPECT_TRUE(find<widgets::QuantityEdit>(*panel, "Hold-off")->isEnabled());
}

TEST_F(MonitorCaptureTest, aLongWindowIsCapturedAtAPartOfTheLoopsRate) {
    captureHall();
    enter("Window", "10"); // 4096 rows of 3 ms cover it
    ASSERT_TRUE(wait([&] { return state().startsWith("Stopped after an event"); })) << state().toStdString();
    const auto range = *stack().history()->range();
    EXPECT_NEAR(range.begin_s, -1024 * 0.003, 1e-12);
    EXPECT_NEAR(range.end_s, 3071 * 0.003, 1e-12);
    EXPECT_TRUE(state().contains("333.3")) << state().toStdString();
}

TEST_F(MonitorCaptureTest, aReferenceThatStartsIsTheEvent) {
    press(Qt::Key_T);
    choose("Mode", "Single");
    choose("Event in", "Board");
    EXPECT_EQ(box("Source").currentText(), "Reference start");
    ASSERT_TRUE(wait([&] { return words() == "Waiting"; })) << state().toStdString();
    EXPECT_TRUE(state().startsWith("Waiting until the reference starts; captures Hall A, Hall B"));
    DriveControl& drive = bench().drive();
    drive.setMode(devices::BoardMode::Current);
    ASSERT_TRUE(wait([&] { return drive.canArm(); }));
    drive.arm();
    ASSERT_TRUE(wait([&] { return drive.canMove(); }));
    drive.startReference({{"reference.shape", 1.0}, // a step
                          {"reference.amplitude", 0.5},
                          {"reference.base", 0.0},
                          {"reference.duration", 60.0},
                          {"reference.start", 1.0}});
    ASSERT_TRUE(wait([&] { return state().startsWith("Stopped after an event"); })) << state().toStdString();
    EXPECT_TRUE(bench().session().report().board.isArmed) << "who captures disturbs no motion";
    const std::vector<double> current = shown("current_command");
    ASSERT_EQ(current.size(), Rows);
    EXPECT_EQ(current[Rows / 4 - 1], 0.0);
    EXPECT_NE(current[Rows / 4 + 1], 0.0);
}

TEST_F(MonitorCaptureTest, aRecordingIsCompleteBeforeTheCaptureIsRead) {
    QTemporaryDir folder;
    bench().recording().setFolder(folder.path());
    bench().recording().start();
    ASSERT_TRUE(wait([&] { return bench().recording().isRecording(); }));
    captureHall();
    ASSERT_TRUE(wait([&] { return words() == "Captured"; })) << state().toStdString();
    QTest::qWait(200);
    EXPECT_EQ(words(), "Captured");
    EXPECT_EQ(stack().history(), &bench().history());
    bench().recording().stop();
    ASSERT_TRUE(wait([&] { return state().startsWith("Stopped after an event"); })) << state().toStdString();
    EXPECT_EQ(bench().recording().status().missingRows, 0U);
    EXPECT_EQ(bench().recording().status().droppedRows, 0U);
    EXPECT_EQ(shown("hall.a").size(), Rows);
}

TEST_F(MonitorCaptureTest, waitsWithEverythingWhileAProcedureHasTheDevice) {
    std::atomic<bool> isOver = false;
    ASSERT_TRUE(session().runProcedure(
        "test",
        [&isOver](devices::Device& device, const ProcedureObserver&) -> Result<void> {
            while (!isOver) {
                if (auto waited = device.clock().waitFor(0.05); !waited) {
                    return waited;
                }
            }
            return {};
        },
        [](const Result<void>&) {}));
    captureHall();
    ASSERT_TRUE(wait([&] { return words() == "On hold"; })) << state().toStdString();
    EXPECT_EQ(parameter("capture.pretrigger"), 0.0) << "nothing was ordered";
    isOver = true;
    ASSERT_TRUE(wait([&] { return state().startsWith("Stopped after an event"); })) << state().toStdString();
    EXPECT_EQ(shown("hall.a").size(), Rows);
}

TEST_F(MonitorCaptureTest, waitsAgainByItselfAndKeepsTheMarksOfTheLiveSamples) {
    press(Qt::Key_M);
    ASSERT_EQ(stack().markers().size(), 1U);
    const auto markers = stack().markers();
    captureHall();
    choose("Mode", "Normal");
    ASSERT_TRUE(wait([&] { return stack().history() != &bench().history(); })) << state().toStdString();
    EXPECT_TRUE(stack().markers().empty());
    EXPECT_FALSE(stack().action(widgets::LivePlotStack::Command::Marker)->isEnabled());
    const std::vector<double> first = shown("hall.a");
    ASSERT_TRUE(wait([&] { return shown("hall.a") != first; })) << "the next one";
    press(Qt::Key_T);
    EXPECT_EQ(stack().markers(), markers);
    EXPECT_TRUE(stack().action(widgets::LivePlotStack::Command::Marker)->isEnabled());
}

TEST_F(MonitorCaptureTest, markersThatComeMeanwhileAreOfTheLiveSamples) {
    press(Qt::Key_M);
    captureHall();
    choose("Mode", "Normal");
    ASSERT_TRUE(wait([&] { return stack().history() != &bench().history(); })) << state().toStdString();
    int changes = 0;
    QObject::connect(panel.get(), &MonitorPanel::markersChanged, panel.get(), [&] { ++changes; });
    panel->takeRecordedMarker(1.5, QStringLiteral("knock"));
    EXPECT_EQ(changes, 1) << "the further Monitors hear of it";
    EXPECT_TRUE(stack().markers().empty()) << "a capture has none";
    ASSERT_EQ(panel->markers().size(), 2U);
    std::vector<widgets::PlotMarker> more = panel->markers();
    more.push_back({1.75, QStringLiteral("of another Monitor")});
    panel->setMarkers(more);
    EXPECT_TRUE(stack().markers().empty());
    press(Qt::Key_T);
    EXPECT_EQ(stack().markers(), more);
}

// The plots show no markers then, which must not read as "all were removed".
TEST_F(MonitorCaptureTest, aRecordingThatEndsWhileACaptureIsShownKeepsItsMarkers) {
    captureHall();
    ASSERT_TRUE(wait([&] { return state().startsWith("Stopped after an event"); })) << state().toStdString();
    RecordPanel record(bench());
    QObject::connect(&record, &RecordPanel::marked, panel.get(), &MonitorPanel::takeRecordedMarker);
    QTemporaryDir folder;
    QString recorded;
    QObject::connect(&bench().recording(), &RecordingControl::finished, panel.get(),
                     [&](const QString& path, const RecorderStatus&) { recorded = path; });
    bench().recording().setFolder(folder.path());
    bench().recording().start();
    auto* note = record.findChild<QLineEdit*>(QStringLiteral("markerNote"));
    ASSERT_TRUE(wait([&] { return note->isEnabled() && bench().recording().status().rows > 50; }));
    note->setText(QStringLiteral("knock"));
    QTest::keyClick(note, Qt::Key_Return);
    ASSERT_TRUE(stack().markers().empty()) << "a capture has none";
    ASSERT_TRUE(wait([&] { return bench().recording().status().elapsed_s > 1.0; }));
    bench().recording().stop();
    ASSERT_TRUE(wait([&] { return !recorded.isEmpty(); }));
    const auto kept = [&] {
        const auto file = devices::readRecordingFile(recorded.toStdString());
        return file ? file->meta.markers : std::vector<devices::RecordingMeta::Marker>();
    };
    ASSERT_TRUE(wait([&] { return kept().size() == 1; }));
    EXPECT_EQ(kept().front().text, "knock");
    press(Qt::Key_T);
    ASSERT_TRUE(wait([&] { return !bench().recording().isRecording(); }));
    ASSERT_EQ(kept().size(), 1U) << "nor when the live samples are back";
    ASSERT_EQ(stack().markers().size(), 1U);
    EXPECT_EQ(stack().markers().front().text, QStringLiteral("knock"));
}

TEST_F(MonitorCaptureTest, pairsOfCursorsBelongToTheTimeAxisTheyWerePutOn) {
    widgets::CursorPairs live({{"rise", 1.0, 2.0}, {"fall", 3.0, 4.0}}, 0);
    live.setVisible(true);
    stack().setCursorPairs(live);
    const std::vector<CursorChoice> kept = panel->view().cursors;
    ASSERT_EQ(kept.size(), 2U);
    captureHall();
    ASSERT_TRUE(wait([&] { return state().startsWith("Stopped after an event"); })) << state().toStdString();
    EXPECT_EQ(stack().cursorPairs().list().size(), 1U);
    EXPECT_DOUBLE_EQ(stack().cursors().a_s, 0.0); // the event
    EXPECT_TRUE(stack().cursors().isVisible);
    EXPECT_EQ(panel->view().cursors, kept); // a project keeps the live ones
    press(Qt::Key_T);
    EXPECT_EQ(stack().cursorPairs(), live);
}

TEST_F(MonitorCaptureTest, saysWhatFailed) {
    MonitorView view = panel->view();
    view.trigger.isOn = true;
    view.trigger.isBoard = true;
    view.trigger.mode = control::TriggerMode::Single;
    view.trigger.source = "hall.north";
    panel->setView(view);
    ASSERT_TRUE(wait([&] { return state().startsWith("the device has no signal 'hall.north'"); }))
        << state().toStdString();
    EXPECT_EQ(stack().history(), &bench().history());
}

TEST_F(MonitorCaptureTest, aDeviceThatGoesTakesTheWaitWithItAndNotWhatIsShown) {
    captureHall();
    ASSERT_TRUE(wait([&] { return state().startsWith("Stopped after an event"); })) << state().toStdString();
    session().disconnectDevice();
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Disconnected; }));
    EXPECT_EQ(shown("hall.a").size(), Rows);
    press(Qt::Key_T);
    EXPECT_EQ(stack().history(), &bench().history());
}

} // namespace
} // namespace halbench::app
