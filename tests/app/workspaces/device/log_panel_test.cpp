#include "app/procedures/excite/move_reference.h"
#include "app/workbench/drive_control.h"
#include "app/workspaces/device/log_panel.h"
#include "devices/history/page_file.h"
#include "tests/app/workspaces/bench_fixture.h"

namespace halbench::app {
namespace {

class LogPanelTest : public BenchTest {
protected:
    void SetUp() override {
        BenchTest::SetUp();
        log = std::make_unique<LogPanel>(bench());
    }
    void TearDown() override { log.reset(); }
    bool tells(const char* words) const { return log->text().contains(QString::fromUtf8(words)); }

    std::unique_ptr<LogPanel> log;
};

TEST_F(LogPanelTest, tellsWhichSettingsWereChangedAndByWhom) {
    connectTo("sim:htm", 5.0);
    EXPECT_FALSE(tells("gain.kp")); // connecting changes nothing
    bench().setDisplayUnits({widgets::AngleUnit::Radian, SpeedUnit::RadiansPerSecond});
    bench().writeValues({{"gain.kp", 12.5}}, [](const Result<void>&) {});
    ASSERT_TRUE(wait([&] { return tells("parameters\tgain.kp 10 \u2192 12.5 A/rad"); }))
        << log->text().toStdString();
    EXPECT_FALSE(tells("found changed"));
    session().request(
        [](devices::Device& device) {
            const ParameterValue change{"limit.current", 3.0};
            return device.writeParameters({&change, 1});
        },
        [this](const Result<void>&) { bench().refreshValues(); });
    EXPECT_TRUE(wait([&] { return tells("found changed: limit.current 4 \u2192 3 A"); }))
        << log->text().toStdString();
}

TEST_F(LogPanelTest, aHistoryThatCannotBeKeptIsToldOnce) {
    devices::PageFileConfig config;
    config.folder = "/proc/no/such/folder";
    const auto pages = std::make_shared<devices::PageFile>(config);
    bench().setHistoryPages(pages);
    bench().drainSamples();
    EXPECT_FALSE(tells("history"));
    pages->put({});
    pages->waitUntilIdle();
    bench().drainSamples();
    bench().drainSamples();
    EXPECT_EQ(log->text().count(QStringLiteral("cannot keep history in '/proc/no/such/folder'")), 1);
}

TEST_F(LogPanelTest, aChangeTooSmallForFiveDigitsIsToldWithAll) {
    connectTo("sim:htm", 5.0);
    bench().writeValues({{"limit.current", 3.999999}}, [](const Result<void>&) {});
    EXPECT_TRUE(wait([&] { return tells("limit.current 4 \u2192 3.99999"); })) << log->text().toStdString();
}

TEST_F(LogPanelTest, aProcedureIsToldWithItsStartAndItsVerdict) {
    struct Judged {
        DataQuality quality;
    };
    connectTo("sim:htm", 5.0);
    const auto run = [this](const Result<Judged>& result) {
        ASSERT_TRUE(session().runProcedure(
            "Move", [result](devices::Device&, const ProcedureObserver&) { return result; },
            [](const Result<Judged>&) {}));
        ASSERT_TRUE(wait([&] { return session().procedure().isEmpty(); }));
    };
    run(Judged{});
    EXPECT_TRUE(tells("Move\tstarted")) << log->text().toStdString();
    EXPECT_TRUE(tells("Move\tdone, good")) << log->text().toStdString();
    run(Judged{{Verdict::Doubtful, {}}});
    EXPECT_TRUE(tells("Move\tdone, doubtful")) << log->text().toStdString();
    run(failure(ErrorCode::DeviceRefused, "the board does not move"));
    EXPECT_TRUE(tells("Move\tfailed: the board does not move")) << log->text().toStdString();
    run(failure(ErrorCode::Interrupted, "cancelled by the user"));
    EXPECT_TRUE(tells("Move\tcancelled")) << log->text().toStdString();
}

TEST_F(LogPanelTest, aMotionByHandIsToldWithItsStartAndWhatEndedIt) {
    connectTo("sim:htm", 5.0);
    bench().liveSignals().want(log.get(), {"position", "reference", "reference.running"}); // as Drive does
    DriveControl& drive = bench().drive();
    const auto start = [&] {
        drive.arm();
        ASSERT_TRUE(wait([&] { return drive.canMove(); }));
        MoveReference sine;
        sine.shape = MoveReference::Shape::Sine;
        sine.amplitude = 0.2;
        sine.frequency_Hz = 1.0;
        drive.startReference(generatorParameters(sine, 100.0, drive.axis().generator));
        ASSERT_TRUE(wait([&] { return tells("sine, position mode\tstarted"); })) << log->text().toStdString();
    };
    start();
    drive.stopReference();
    ASSERT_TRUE(wait([&] { return log->text().endsWith("sine, position mode\tended"); }))
        << log->text().toStdString();
    drive.disarm();
    ASSERT_TRUE(wait([&] { return drive.canArm(); }));
    start();
    session().stopActuator();
    EXPECT_TRUE(wait([&] { return tells("sine, position mode\tended: "); })) << log->text().toStdString();
    EXPECT_LT(log->text().indexOf("stop\t"), log->text().indexOf("mode\tended: "));
}

TEST_F(LogPanelTest, theValuesOfTheNextDeviceAreNoChange) {
    connectTo("sim:htm", 5.0);
    bench().writeValues({{"gain.kp", 12.5}}, [](const Result<void>&) {});
    ASSERT_TRUE(wait([&] { return tells("gain.kp"); }));
    session().disconnectDevice();
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Disconnected; }));
    connectTo("sim:htm?seed=2", 5.0);
    ASSERT_TRUE(wait([&] { return bench().deviceValue("gain.kp") == 10.0; }));
    EXPECT_EQ(log->text().count("gain.kp"), 1) << log->text().toStdString();
}

} // namespace
} // namespace halbench::app
