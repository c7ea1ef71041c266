#include "tests/devices/firmware/avr/avr_fixture.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace halbench::simavr {
namespace {

using devices::BoardMode;

constexpr double Tick_s = 2e-3; // HB_TICK_MS of the board
/// The next faster tick whose multiples make the 10 ms of the position loop with its own cycle a whole number
/// of timer counts: 1.25 ms, 800 Hz.
constexpr double FasterTick_s = 1.25e-3;

std::vector<std::string> everySignal(const devices::Device& device) {
    std::vector<std::string> names;
    for (const auto& signal : device.catalogue().signals) {
        names.push_back(signal.name);
    }
    return names;
}

/// Everything the board does at once: position loop with feed-forward and friction help, sine reference,
/// every signal at 100 Hz, parameters written and read all the time.
void work(AvrBench& bench, double time_s, std::size_t& rows) {
    for (const auto& [name, value] : {std::pair<const char*, double>{"gain.kp", 40.0},
                                      {"gain.ki", 60.0},
                                      {"gain.kd", 1.4},
                                      {"feedforward.inertia", 0.0385},
                                      {"feedforward.viscous", 0.086},
                                      {"feedforward.coulomb", 1.29},
                                      {"stiction.current", 1.29},
                                      {"commutation.advance", 1e-4},
                                      {"window.position_enabled", 1.0},
                                      {"window.position", 100.0},
                                      {"hall.gain_ratio", 1.01},
                                      {"hall.quadrature", 0.01},
                                      {"reference.shape", 3.0},
                                      {"reference.amplitude", 3.0},
                                      {"reference.frequency", 0.7},
                                      {"reference.duration", 1000.0},
                                      {"hb.mode", static_cast<double>(BoardMode::Position)}}) {
        ASSERT_TRUE(bench.write(name, value)) << name;
    }
    const auto started = bench.device->startStream(
        {everySignal(*bench.device), 100.0}, [&rows](const SampleBlockPtr& block) { rows += block->rows(); });
    ASSERT_TRUE(started) << started.error().message;
    ASSERT_TRUE(bench.device->arm());
    ASSERT_TRUE(bench.write("reference.start", 1.0));
    bench.board->forgetTicks();
    const double end_s = bench.board->time_s() + time_s;
    for (int i = 0; bench.board->time_s() < end_s; ++i) {
        ASSERT_TRUE(bench.write("gain.kp", i % 2 == 0 ? 39.0 : 40.0));
        bench.wait(0.02);
    }
}

TEST(AvrBudget, theLongestTickTakesAtMostFourFifthsOfThePeriodAndTheNextFasterRateWouldNot) {
    AvrBench bench = openBench({}, 3);
    ASSERT_TRUE(bench.device);
    std::size_t rows = 0;
    work(bench, 20.0, rows);
    const TickTimes& ticks = bench.board->ticks();
    const double worst_s = static_cast<double>(ticks.worst_cycles) / AvrCore::Clock_Hz;
    const double mean_s =
        static_cast<double>(ticks.total_cycles) / static_cast<double>(ticks.count) / AvrCore::Clock_Hz;
    fmt::print(
        "control tick: period {:.0f} us, longest {:.0f} us = {:.1f} %, mean {:.0f} us, starts {:.0f} us "
        "early to {:.0f} us late, untouched RAM {} octets\n",
        1e6 * Tick_s, 1e6 * worst_s, 100.0 * worst_s / Tick_s, 1e6 * mean_s,
        1e6 * (Tick_s - static_cast<double>(ticks.shortest_period_cycles) / AvrCore::Clock_Hz),
        1e6 * (static_cast<double>(ticks.longest_period_cycles) / AvrCore::Clock_Hz - Tick_s),
        bench.board->core().untouchedRam());
    EXPECT_LE(worst_s, 0.8 * Tick_s);
    EXPECT_GT(worst_s, 0.8 * FasterTick_s);
    // No tick was left out, and none waited for a command for longer than half a period.
    EXPECT_NEAR(static_cast<double>(ticks.count), 20.0 / Tick_s, 200.0);
    EXPECT_LT(static_cast<double>(ticks.longest_period_cycles) / AvrCore::Clock_Hz, 1.5 * Tick_s);
    // What the deepest call so far left of the stack: an interrupt more needs 30 octets.
    EXPECT_GE(bench.board->core().untouchedRam(), 48U);
    EXPECT_EQ(bench.read("torn_count"), 0.0);
    EXPECT_TRUE(bench.device->state().isArmed);
}

TEST(AvrBudget, everySignalArrivesAHundredTimesASecondWithoutAGap) {
    AvrBench bench = openBench({}, 3);
    ASSERT_TRUE(bench.device);
    std::vector<double> times;
    const auto started =
        bench.device->startStream({everySignal(*bench.device), 100.0}, [&times](const SampleBlockPtr& block) {
            times.insert(times.end(), block->time_s.begin(), block->time_s.end());
        });
    ASSERT_TRUE(started) << started.error().message;
    bench.wait(60.0);
    ASSERT_GE(times.size(), 5990U);
    for (std::size_t i = 1; i < times.size(); ++i) {
        ASSERT_NEAR(times[i] - times[i - 1], 0.01, 1e-9) << i;
    }
    EXPECT_EQ(bench.device->statistics().packetsLost, 0U);
    EXPECT_EQ(bench.device->statistics().packetsDamaged, 0U);
}

} // namespace
} // namespace halbench::simavr
