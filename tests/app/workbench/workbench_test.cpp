#include "app/workbench/workbench.h"

#include <QCoreApplication>
#include <QtTest/QTest>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

constexpr int Patience_ms = 120000;

class WorkbenchTest : public testing::Test {
protected:
    void connectMotor(double speed_ratio) {
        bench.session().connectDevice("sim:htm", {speed_ratio});
        ASSERT_TRUE(QTest::qWaitFor([&] { return !bench.deviceValues().empty(); }, Patience_ms));
    }

    int m_argumentCount = 1;
    char m_name[5] = "test";
    char* m_arguments[2] = {m_name, nullptr};
    QCoreApplication application{m_argumentCount, m_arguments};
    Workbench bench;
};

TEST_F(WorkbenchTest, knowsEveryValueOnceConnected) {
    connectMotor(0.0);
    EXPECT_EQ(bench.deviceValues().size(), bench.session().catalogue().parameters.size());
    EXPECT_EQ(bench.deviceValue("gain.kp"), 10.0); // the published preset, htm-theory.md section 8.1
    EXPECT_FALSE(bench.deviceValue("gain.colour"));
}

TEST_F(WorkbenchTest, aWriteShowsWhatTheDeviceReadsBack) {
    connectMotor(0.0);
    std::optional<Result<void>> written;
    bench.writeValues({{"gain.kp", 12.5}}, [&](Result<void> result) { written = result; });
    ASSERT_TRUE(QTest::qWaitFor([&] { return written.has_value(); }, Patience_ms));
    ASSERT_TRUE(*written) << written->error().message;
    EXPECT_EQ(bench.deviceValue("gain.kp"), 12.5);
}

TEST_F(WorkbenchTest, aRefusedWriteChangesNothing) {
    connectMotor(0.0);
    std::optional<Result<void>> written;
    bench.writeValues({{"gain.ki", 1.0}, {"gain.kp", -1e9}}, [&](Result<void> result) { written = result; });
    ASSERT_TRUE(QTest::qWaitFor([&] { return written.has_value(); }, Patience_ms));
    ASSERT_FALSE(*written);
    EXPECT_EQ(written->error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(bench.deviceValue("gain.kp"), 10.0);
    EXPECT_EQ(bench.deviceValue("gain.ki"), 0.1);
}

TEST_F(WorkbenchTest, samplesOfTheLiveStreamReachTheHistory) {
    connectMotor(20.0);
    bench.session().setLiveStream({"position", "hall.a"}, 100.0);
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
            bench.drainSamples();
            return bench.history().range("hall.a").value_or(control::TimeRange{}).length_s() > 1.0;
        },
        Patience_ms));
    EXPECT_EQ(bench.history().unit("hall.a"), "T");
    EXPECT_EQ(bench.history().lostRows(), 0U);
}

TEST_F(WorkbenchTest, currentsThatAProcedureCommandsAreNoReferenceOfTheAngle) {
    connectMotor(20.0);
    bench.session().setLiveStream({"position", "reference", "status"}, 100.0);
    bool isDone = false;
    bench.session().runProcedure(
        "Spin",
        [](devices::Device& device, const ProcedureObserver&) -> Result<void> {
            const std::vector<ParameterValue> mode = {
                {"hb.mode", static_cast<double>(devices::BoardMode::Current)}};
            const std::vector<ParameterValue> push = {{"hb.setpoint", 0.5}};
            if (!device.writeParameters(mode) || !device.arm() || !device.writeParameters(push)) {
                return failure(ErrorCode::DeviceRefused, "not driven");
            }
            (void)device.clock().waitFor(2.0);
            return device.disarm();
        },
        [&](const Result<void>& driven) { isDone = bool(driven); });
    bench.setCurrentDriven();
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
            bench.drainSamples();
            return isDone;
        },
        Patience_ms));
    bench.drainSamples();
    const auto all = bench.history().range("position").value_or(control::TimeRange{});
    ASSERT_GT(all.length_s(), 1.0);
    std::vector<control::TimedValue> shown;
    bench.history().samples("reference", all, shown);
    EXPECT_FALSE(shown.empty());
    EXPECT_TRUE(std::all_of(shown.begin(), shown.end(), [](const auto& one) {
        return std::isnan(one.value);
    })) << "0.5 A would be drawn as 29 degrees";
}

TEST_F(WorkbenchTest, valuesAreGoneWithTheDevice) {
    connectMotor(0.0);
    bench.refreshValues(); // is on its way while the device is left
    bench.session().disconnectDevice();
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return bench.session().state() == SessionState::Disconnected; }, Patience_ms));
    EXPECT_TRUE(bench.deviceValues().empty());
}

} // namespace
} // namespace halbench::app
