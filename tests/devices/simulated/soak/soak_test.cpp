#include "control/base/units.h"
#include "devices/simulated/registry/simulated_device.h"
#include "tests/memory_in_use.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::devices {
namespace {

constexpr int Hours = 10;
constexpr double Period_s = 0.01;
const std::vector<std::string> Streamed = {"position", "truth.position", "torn_count", "status"};

/// What the stream showed, row after row; keeps no rows.
struct Watch {
    std::int64_t rows = 0;
    std::uint64_t lostRows = 0;
    double worstTime_s = 0.0;
    double worstAngle_rad = 0.0;
    double travelled_rad = 0.0;
    double last_rad = 0.0;
    double tornCycles = 0.0;
    std::int64_t rowsNotArmed = 0;

    void take(const SampleBlock& block) {
        lostRows += block.lostRows;
        for (std::size_t row = 0; row < block.rows(); ++row, ++rows) {
            const double expected_s = static_cast<double>(rows) / 100.0;
            const double truth_rad = block.value(row, 1);
            worstTime_s = std::fmax(worstTime_s, std::fabs(block.time_s[row] - expected_s));
            worstAngle_rad = std::fmax(worstAngle_rad, std::fabs(block.value(row, 0) - truth_rad));
            travelled_rad += std::fabs(truth_rad - last_rad);
            last_rad = truth_rad;
            tornCycles = block.value(row, 2);
            rowsNotArmed += block.value(row, 3) == 1.0 ? 0 : 1;
        }
    }
};

void set(Device& device, const std::vector<ParameterValue>& values) {
    const auto written = device.writeParameters(values);
    ASSERT_TRUE(written) << written.error().message;
}

void startSine(Device& device) {
    set(device, {{"hb.mode", static_cast<double>(BoardMode::Position)}});
    ASSERT_TRUE(device.arm());
    set(device, {{"reference.shape", 3.0},
                 {"reference.amplitude", Pi},
                 {"reference.frequency", 0.1},
                 {"reference.duration", 99000.0},
                 {"reference.start", 1.0}});
}

/// Gains change as one transaction while the motor moves; both sets are stable.
void changeGains(Device& device, int minute) {
    const double gain_A_per_rad = minute % 2 == 0 ? 10.0 : 8.0;
    set(device, {{"gain.kp", gain_A_per_rad}, {"gain.ki", gain_A_per_rad / 100.0}});
}

TEST(Soak, tenHoursOfMotionLoseNothingAndKeepNoMemory) {
    const auto opened = openSimulatedDevice(*parseDeviceUri("sim:htm?seed=5"), {});
    ASSERT_TRUE(opened) << opened.error().message;
    Device& device = **opened;
    Watch watch;
    startSine(device);
    ASSERT_TRUE(
        device.startStream({Streamed, 1.0 / Period_s}, [&](SampleBlockPtr block) { watch.take(*block); }));
    const double start_s = device.clock().now_s();
    double afterFirstHour_MB = 0.0;
    for (int minute = 0; minute < 60 * Hours; ++minute) {
        const auto waited = device.clock().waitFor(start_s + 60.0 * (minute + 1) - device.clock().now_s());
        ASSERT_TRUE(waited) << waited.error().message << " in minute " << minute;
        changeGains(device, minute);
        afterFirstHour_MB = minute == 60 ? memoryInUse_MB() : afterFirstHour_MB;
    }
    const double duration_s = device.clock().now_s() - start_s;
    device.stopStream();

    EXPECT_NEAR(duration_s, 3600.0 * Hours, 0.1); // the last change of gains takes a few cycles
    // Rows lie on the board's 10 ms events; the first comes up to one period after the start.
    EXPECT_NEAR(static_cast<double>(watch.rows), duration_s / Period_s, 2.0);
    EXPECT_EQ(watch.lostRows, 0U);
    EXPECT_EQ(device.statistics().packetsLost, 0U);
    EXPECT_EQ(device.statistics().packetsDamaged, 0U);
    // The board's 32 bit microseconds overflow eight times; a double near 36000 s has 7e-12 s of resolution.
    EXPECT_LT(watch.worstTime_s, 1e-11);
    EXPECT_EQ(watch.tornCycles, 0.0);
    EXPECT_EQ(watch.rowsNotArmed, 0);
    // A sine of 180 degrees travels 4 pi rad in 10 s; friction may hold the rotor back by the band of 8 deg.
    EXPECT_NEAR(watch.travelled_rad / (4.0 * Pi * duration_s / 10.0), 1.0, 0.1);
    // The errors of an uncalibrated specimen: offset, gain, quadrature and bars add up to less than 6
    // degrees.
    EXPECT_LT(radiansToDegrees(watch.worstAngle_rad), 6.0);
    // The allocator's own pages come and go by less than a megabyte; a leak of one octet a row would be 3 MB.
    EXPECT_LT(memoryInUse_MB() - afterFirstHour_MB, 1.0);
}

} // namespace
} // namespace halbench::devices
