#include "devices/open/returning_device.h"
#include "tests/app/procedures/faulty_motor.h"

#include <gtest/gtest.h>

namespace halbench::devices {
namespace {

/// A board behind a link that breaks and is mended at times of a host clock that the test turns.
class ReturningDeviceTest : public testing::Test {
protected:
    ReturningDeviceTest() {
        DeviceReturn back(first->info(), [this]() -> Result<std::unique_ptr<Device>> {
            if (host_s < mended_s) {
                return failure(ErrorCode::DeviceLost, "nothing is plugged in");
            }
            motor.repair();
            return motor.connect();
        });
        device.emplace(std::move(first), std::move(back),
                       HostTime{[this] { return host_s; }, [this](double time_s) { host_s += time_s; }});
        device->setEvents({[this](const Error&, double stream_s) { lost_s.push_back(stream_s); },
                           [this](double outage_s, double) { outages_s.push_back(outage_s); }});
    }

    Result<void> record(double duration_s) {
        const Result<void> started = device->startStream(
            {{"position"}, 100.0}, [this](const SampleBlockPtr& block) { blocks.push_back(block); });
        return started ? device->clock().waitFor(duration_s) : started;
    }

    app::FaultyMotor motor{"imperfections=off"};
    std::unique_ptr<Device> first = motor.connect();
    double host_s = 1000.0;
    double mended_s = 0.0;
    std::optional<ReturningDevice> device;
    std::vector<SampleBlockPtr> blocks;
    std::vector<double> lost_s;
    std::vector<double> outages_s;
};

TEST_F(ReturningDeviceTest, rowsAfterAnOutageLieOnTheGridAndWhatIsMissingIsCounted) {
    motor.faults().unplugAt_s = device->clock().now_s() + 2.0; // the link is older than the device
    mended_s = 1003.0;
    ASSERT_TRUE(record(8.0));
    ASSERT_EQ(outages_s.size(), 1U);
    EXPECT_NEAR(outages_s[0], 3.0, 2.1); // looked for at most two seconds apart
    EXPECT_GE(outages_s[0], 3.0);
    std::uint64_t rows = 0;
    std::uint64_t missing = 0;
    std::size_t gaps = 0;
    for (const SampleBlockPtr& block : blocks) {
        for (std::size_t row = 0; row < block->rows(); ++row) {
            const auto place = static_cast<double>(rows + missing + row + block->lostRows);
            ASSERT_DOUBLE_EQ(block->time_s[row], place / 100.0) << "a row in its place of the grid";
        }
        rows += block->rows();
        missing += block->lostRows;
        gaps += block->lostRows > 0 ? 1 : 0;
    }
    EXPECT_EQ(gaps, 1U);
    EXPECT_NEAR(static_cast<double>(missing) / 100.0, outages_s[0], 0.1); // rows on their way when it broke
    EXPECT_FALSE(device->lost());
}

TEST_F(ReturningDeviceTest, countsOfTheLinkGoOnOverAnOutage) {
    motor.faults().unplugAt_s = device->clock().now_s() + 2.0;
    mended_s = 1003.0;
    ASSERT_TRUE(record(1.5));
    const LinkStatistics before = device->statistics();
    EXPECT_EQ(before.returns, 0U);
    ASSERT_TRUE(device->clock().waitFor(6.0));
    const LinkStatistics after = device->statistics();
    EXPECT_EQ(after.returns, 1U);
    EXPECT_GT(after.packetsReceived, before.packetsReceived + 50U) << "rows of both links are counted";
    EXPECT_GT(after.packetsSent, before.packetsSent);
}

TEST_F(ReturningDeviceTest, timeGoesOnWithoutTheDeviceAndWhyIsKnown) {
    mended_s = 1e9;
    motor.faults().isUnplugged = true;
    ASSERT_TRUE(device->clock().waitFor(5.0));
    ASSERT_TRUE(device->lost());
    EXPECT_NEAR(device->clock().now_s(), 5.0, 0.5); // the loss itself takes its time-outs
    const ParameterValue gain{"gain.kp", 1.0};
    EXPECT_EQ(device->writeParameters({&gain, 1}).error().code, ErrorCode::DeviceLost);
    EXPECT_FALSE(device->arm());
}

TEST_F(ReturningDeviceTest, comesBackDisarmed) {
    ASSERT_TRUE(device->arm());
    ASSERT_TRUE(motor.isArmed());
    motor.faults().isUnplugged = true;
    mended_s = 1000.5;
    ASSERT_TRUE(device->clock().waitFor(2.0));
    ASSERT_FALSE(device->lost());
    EXPECT_FALSE(motor.isArmed());
    EXPECT_FALSE(device->state().isArmed);
}

} // namespace
} // namespace halbench::devices
