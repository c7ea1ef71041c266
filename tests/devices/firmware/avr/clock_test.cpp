#include "tests/devices/firmware/avr/long_running.h"

namespace halbench::simavr {
namespace {

using devices::BoardMode;

// Time stamps across the turns of the board's 32-bit clock (resources/help/protocol.md 3.9 and gate 2). A
// turn takes 71.6 minutes: here the board is one that has been on for nearly so long. Only its count of ticks
// is set, once and before anybody connects.

constexpr std::uint32_t Lead = 3000; // ticks: 6 s, of which connecting takes 4
constexpr double Duration_s = 4.0;
constexpr double Ramp_rad_s = 1.0;

class AvrClock : public testing::TestWithParam<int> {};

TEST_P(AvrClock, aStreamAcrossATurnHasEachRowOnceWhileTheMotorMoves) {
    const std::uint32_t turn = ticksAtTurn(GetParam());
    LongRunningBench bench = openLongRunning(turn - Lead);
    ASSERT_TRUE(bench.device);
    for (const auto& [name, value] : {std::pair{"hb.mode", static_cast<double>(BoardMode::Position)},
                                      {"reference.shape", 2.0}, // a ramp
                                      {"reference.amplitude", 0.0},
                                      {"reference.rate", Ramp_rad_s},
                                      {"reference.duration", 60.0}}) {
        ASSERT_TRUE(bench.write(name, value)) << name;
    }
    ASSERT_TRUE(bench.device->arm());
    ASSERT_TRUE(bench.write("reference.start", 1.0));
    bench.wait(0.1);
    ASSERT_LT(bench.line->ticks(), turn);
    CountedRows rows;
    const auto streamed = rows.stream(*bench.device, "reference", Duration_s);
    ASSERT_TRUE(streamed) << streamed.error().message;
    ASSERT_GT(bench.line->ticks(), turn);
    expectEachRowOnce(rows, Duration_s);
    EXPECT_EQ(bench.device->statistics().packetsLost, 0U);
    EXPECT_EQ(bench.device->statistics().packetsDamaged, 0U);
    // The ramp counts the ticks by itself: a row that is missing or there twice would show as 0.02 or 0. The
    // board's floats near 5 rad are good to 1e-6.
    for (std::size_t i = 1; i < rows.values.size(); ++i) {
        ASSERT_NEAR(rows.values[i] - rows.values[i - 1], Ramp_rad_s / CountedRows::Rate_Hz, 1e-5) << i;
    }
    EXPECT_TRUE(bench.device->state().isArmed) << "neither watchdog nor supervision notices the turn";
}

INSTANTIATE_TEST_SUITE_P(Turn, AvrClock, testing::Values(1, 2));

} // namespace
} // namespace halbench::simavr
