#include "tests/devices/firmware/avr/avr_fixture.h"

#include <vector>

// The board of thirty_channels/: what the library streams over a line of 115200 Bd.

namespace halbench::simavr {
namespace {

constexpr int Channels = 30;
constexpr double Rate_Hz = 100.0;
constexpr double Duration_s = 60.0;
// As in thirty_channels/main.c.
constexpr std::uint64_t StepOfSample = 37;
constexpr std::uint64_t StepOfChannel = 1009;
constexpr std::uint64_t Range = 65536;

/// How many values are not what their sample and channel make them, counted from the first one.
int wrongValues(const std::vector<std::vector<double>>& rows) {
    int wrong = 0;
    for (std::size_t row = 0; row < rows.size(); ++row) {
        for (std::size_t channel = 0; channel < rows[row].size(); ++channel) {
            const auto first = static_cast<std::uint64_t>(rows[0][0]);
            const std::uint64_t expected = (first + StepOfSample * row + StepOfChannel * channel) % Range;
            wrong += rows[row][channel] != static_cast<double>(expected) ? 1 : 0;
        }
    }
    return wrong;
}

TEST(AvrChannels, thirtyArriveAHundredTimesASecondForAMinuteWithoutAGap) {
    AvrBench bench = connect(makeBoard(perfectMotor(), 1, boardProgram("thirty_channels.elf")));
    ASSERT_TRUE(bench.device);
    std::vector<std::string> names;
    for (int i = 0; i < Channels; ++i) {
        names.push_back("channel." + std::to_string(i));
    }
    std::vector<double> times;
    std::vector<std::vector<double>> rows;
    const auto started = bench.device->startStream({names, Rate_Hz}, [&](const SampleBlockPtr& block) {
        for (std::size_t row = 0; row < block->rows(); ++row) {
            times.push_back(block->time_s[row]);
            rows.emplace_back();
            for (std::size_t channel = 0; channel < Channels; ++channel) {
                rows.back().push_back(block->value(row, channel));
            }
        }
    });
    ASSERT_TRUE(started) << started.error().message;
    bench.wait(Duration_s);
    ASSERT_GE(static_cast<double>(times.size()), Duration_s * Rate_Hz - 10.0); // those still on the line
    for (std::size_t i = 1; i < times.size(); ++i) {
        ASSERT_NEAR(times[i] - times[i - 1], 1.0 / Rate_Hz, 1e-9) << i;
    }
    EXPECT_EQ(wrongValues(rows), 0);
    EXPECT_EQ(bench.device->statistics().packetsLost, 0U);
    EXPECT_EQ(bench.device->statistics().packetsDamaged, 0U);
}

} // namespace
} // namespace halbench::simavr
