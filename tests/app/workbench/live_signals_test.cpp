#include "app/workbench/live_signals.h"
#include "app/workbench/recording_control.h"
#include "app/workspaces/monitor/monitor_panel.h"
#include "devices/formats/recording_file.h"
#include "tests/app/workspaces/bench_fixture.h"
#include "tests/app/workspaces/fast_recording.h"
#include "widgets/controls/message_bar.h"

#include <QTemporaryDir>

#include <algorithm>

namespace halbench::app {
namespace {

class LiveSignalsTest : public BenchTest {
protected:
    LiveSignals& live() { return bench().liveSignals(); }
    RecordingControl& recording() { return bench().recording(); }
    bool isStreamed(const std::string& name) {
        return std::count(live().streamed().begin(), live().streamed().end(), name) == 1;
    }
    void startRecording() {
        recording().setFolder(folder.path());
        recording().setName("run");
        recording().start();
        ASSERT_TRUE(wait([&] { return recording().status().rows > 50; }));
    }
    void endRecording() {
        recording().stop();
        ASSERT_TRUE(wait([&] { return !recording().isRecording(); }));
    }

    QTemporaryDir folder;
    QObject client;
    QObject other;
};

TEST_F(LiveSignalsTest, aSignalPlottedWhileRecordingWaitsUntilThatHasEnded) {
    connectTo("sim:htm", 5.0);
    live().want(&other, {"reference.segment"});
    startRecording();
    const std::vector<std::string> recorded = live().streamed();
    ASSERT_TRUE(isStreamed("reference.segment"));
    ASSERT_FALSE(isStreamed("reference.running"));
    int changes = 0;
    QObject::connect(&live(), &LiveSignals::changed, &client, [&] { ++changes; });
    live().want(&client, {"reference.running", "speed"});
    live().want(&other, {}); // what is recorded is not taken away either
    live().wantRate(&client, 100.0);
    EXPECT_EQ(live().streamed(), recorded);
    EXPECT_EQ(live().postponed(), std::vector<std::string>{"reference.running"});
    EXPECT_EQ(changes, 1);
    const auto rows = recording().status().rows;
    ASSERT_TRUE(wait([&] { return recording().status().rows > rows + 100; }));
    endRecording();
    EXPECT_TRUE(isStreamed("reference.running")) << "it came by itself";
    EXPECT_FALSE(isStreamed("reference.segment"));
    EXPECT_TRUE(live().postponed().empty());

    const auto file = devices::readRecordingFile(folder.filePath("run.csv").toStdString());
    ASSERT_TRUE(file) << file.error().message;
    const Recording& run = file->recording;
    EXPECT_EQ(run.lostRows, 0U);
    ASSERT_GT(run.rows(), 150U);
    EXPECT_NEAR(run.time_s.back() - run.time_s.front(), 0.001 * static_cast<double>(run.rows() - 1), 1e-6)
        << "every row is there";
    EXPECT_GE(run.layout->indexOf("reference.segment"), 0);
    const std::vector<double> segment = run.column("reference.segment");
    EXPECT_TRUE(std::none_of(segment.begin(), segment.end(), [](double value) { return value != value; }));
}

TEST_F(LiveSignalsTest, theMonitorSaysWhatIsNotInTheRunningRecording) {
    MonitorPanel panel(bench());
    panel.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
    connectTo("sim:htm", 5.0);
    startRecording();
    auto* message = panel.findChild<widgets::MessageBar*>();
    panel.plot("speed", true); // is recorded: at once, and nothing to say
    EXPECT_TRUE(message->message().text.isEmpty());
    panel.plot("reference.running", true);
    EXPECT_EQ(message->message().severity, widgets::Severity::Information);
    EXPECT_EQ(message->message().text, "Not in the running recording: reference.running");
    endRecording();
    EXPECT_TRUE(message->message().text.isEmpty());
    EXPECT_TRUE(wait([&] { return bench().history().latest("reference.running").has_value(); }));
}

TEST_F(LiveSignalsTest, aRecordingThatEndsByAFaultLetsTheStreamGoToo) {
    connectTo("sim:htm", 5.0);
    startRecording();
    session().disconnectDevice();
    ASSERT_TRUE(wait([&] { return !recording().isRecording(); }));
    live().want(&client, {"reference.running"});
    connectTo("sim:htm", 5.0);
    EXPECT_TRUE(isStreamed("reference.running"));
}

TEST_F(LiveSignalsTest, moreRowsComeWhereSomebodyNeedsThem) {
    connectTo(fastReplay(folder, 5000.0), 1.0);
    live().want(&client, {"speed"});
    EXPECT_EQ(live().rate_Hz(), 1000.0) << "as usual";
    EXPECT_EQ(live().greatestRate_Hz(), 5000.0);
    live().wantRate(&client, 5000.0);
    EXPECT_EQ(live().rate_Hz(), 5000.0);
    live().wantRate(&client, 2000.0);
    EXPECT_EQ(live().rate_Hz(), 2500.0) << "the slowest that is no slower";
    live().wantRate(&client, 1e6);
    EXPECT_EQ(live().rate_Hz(), 5000.0) << "what the device has";
    live().wantRate(&client, 10.0);
    EXPECT_EQ(live().rate_Hz(), 1000.0) << "never slower than usual";
    {
        QObject guest;
        live().wantRate(&guest, 5000.0);
        EXPECT_EQ(live().rate_Hz(), 5000.0);
    }
    EXPECT_TRUE(wait([&] { return live().rate_Hz() == 1000.0; })) << "forgotten with who needed it";
}

TEST_F(LiveSignalsTest, aRecordingGetsTheRowsThatItIsSetTo) {
    connectTo(fastReplay(folder, 5000.0), 1.0);
    live().want(&client, {"speed"});
    recording().setRate_Hz(5000.0);
    EXPECT_EQ(live().rate_Hz(), 1000.0) << "not before it begins";
    startRecording();
    EXPECT_EQ(live().rate_Hz(), 5000.0);
    endRecording();
    EXPECT_EQ(live().rate_Hz(), 1000.0);
    const auto file = devices::readRecordingFile(folder.filePath("run.csv").toStdString());
    ASSERT_TRUE(file) << file.error().message;
    EXPECT_DOUBLE_EQ(file->recording.layout->period_s, 2e-4);
}

TEST_F(LiveSignalsTest, aRecordingFasterThanTheDeviceIsRefusedWithWhatIsPossible) {
    connectTo("sim:htm", 5.0);
    QString said;
    QString remedy;
    QObject::connect(&recording(), &RecordingControl::failed, &client,
                     [&](const QString& text, const QString& help) {
                         said = text;
                         remedy = help;
                     });
    recording().setFolder(folder.path());
    recording().setRate_Hz(5000.0);
    recording().start();
    EXPECT_FALSE(recording().isRecording());
    EXPECT_TRUE(said.contains("5000 Hz")) << said.toStdString();
    EXPECT_TRUE(remedy.contains(": 1000 Hz")) << remedy.toStdString();
    recording().setRate_Hz(1000.0);
    recording().start();
    EXPECT_TRUE(recording().isRecording());
}

} // namespace
} // namespace halbench::app
