#include "tests/devices/firmware/mps2/planar_bench.h"

#include <fmt/format.h>

namespace halbench::mps2 {
namespace {

constexpr double Budget_instructions = 60000.0;

std::vector<std::string> everySignal(const devices::Device& device) {
    std::vector<std::string> names;
    for (const SignalSpec& signal : device.catalogue().signals) {
        names.push_back(signal.name);
    }
    return names;
}

/// Sections that let the effort pass, nearly; a1 that is not zero switches one on.
std::vector<ParameterValue> everySection() {
    std::vector<ParameterValue> values;
    for (const char* axis : {"x", "y", "phi"}) {
        for (int section = 1; section <= HB_LAW_SECTIONS; ++section) {
            for (const auto& [coefficient, value] :
                 {std::pair{"b0", 1.0}, {"b1", 0.5}, {"b2", 0.1}, {"a1", 0.5}, {"a2", 0.1}}) {
                values.push_back({fmt::format("filter.{}.{}.{}", axis, section, coefficient), value});
            }
        }
    }
    return values;
}

/// Everything the board does at once: position loops with all filter sections, the tracking filter, currents
/// by all harmonics of the windings, multisines of all lines on three axes, capture and every signal at 1
/// kHz.
void work(Bench& bench, Recording& recording) {
    bench.write({{"hb.home", 1.0}});
    bench.wait(0.005);
    std::vector<ParameterValue> page = everySection();
    page.push_back({"coil.allocation", static_cast<double>(HB_ALLOCATION_FULL)});
    page.push_back({"speed.estimator", 1.0});
    bench.write(page);
    bench.write({{"hb.mode", static_cast<double>(HB_PLANAR_POSITION)}});
    ASSERT_TRUE(bench.device->arm());
    for (const char* axis : {"x", "y", "phi"}) {
        const std::string prefix = std::string("reference.") + axis;
        bench.write({{prefix + ".shape", static_cast<double>(HB_SHAPE_MULTISINE)},
                     {prefix + ".amplitude", 1e-4},
                     {prefix + ".count", static_cast<double>(HB_MULTISINE_LINES)},
                     {prefix + ".frequency", 1.0},
                     {prefix + ".frequency_end", 40.0}});
    }
    bench.write({{"capture.signal_1", 0.0},
                 {"capture.signal_2", 1.0},
                 {"capture.signal_3", 2.0},
                 {"capture.signal_4", 3.0},
                 {"capture.start", 1.0},
                 {"reference.start", 1.0}});
    bench.record(everySignal(*bench.device), recording);
}

// The dearest ticks are those with a chip that contradicts the others and must be found: a least-squares fit
// of all three, then one of each pair, with up to twelve steps each.
TEST(Mps2PlanarBudget, theLongestTickTakesAtMostSixtyThousandInstructions) {
    using models::ChipFault;
    Bench bench = emulatedBench("planar",
                                platenPlant({{100, 2, ChipFault::Clipped},
                                             {180, 2, ChipFault::None},
                                             {200, 1, ChipFault::Dead},
                                             {250, 0, ChipFault::Dead}}),
                                PlanarLine);
    ASSERT_TRUE(bench.device);
    Recording recording;
    work(bench, recording);
    const auto ended = bench.device->clock().waitFor(0.3);
    const TickCosts& costs = bench.emulated->costs();
    fmt::print("control tick: longest {:.0f} instructions of {:.0f}, mean {:.0f} of {} ticks\n",
               costs.worst_instructions, Budget_instructions,
               costs.total_instructions / static_cast<double>(costs.count), costs.count);
    EXPECT_LE(costs.worst_instructions, Budget_instructions);
    // It did all that: a chip was left out, another one, and with two of them gone the board gave up.
    EXPECT_FALSE(ended);
    const std::vector<double> leftOut = recording.column("chips_left_out");
    EXPECT_EQ(std::count(leftOut.begin(), leftOut.end(), 4.0), 80);
    EXPECT_EQ(std::count(leftOut.begin(), leftOut.end(), 2.0), 50);
    EXPECT_EQ(bench.signal("fault"), static_cast<double>(HB_FAULT_SENSOR_RANGE));
    EXPECT_EQ(recording.lostRows, 0U);
    EXPECT_EQ(bench.signal("torn_count"), 0.0);
}

} // namespace
} // namespace halbench::mps2
