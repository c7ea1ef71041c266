#include "control/base/random.h"
#include "tests/devices/firmware/mps2/planar_motion.h"

#include <fmt/format.h>

#include <chrono>
#include <tuple>

namespace halbench::mps2 {
namespace {

TEST(Mps2PlanarNight, theSameRunGivesTheSameBitsAndTheSameInstructions) {
    std::vector<Motion> motions;
    std::vector<TickCosts> costs;
    for (int run = 0; run < 2; ++run) {
        Bench bench = emulatedBench("planar", platenPlant(chipFailsInMotion()), PlanarLine);
        ASSERT_TRUE(bench.device);
        motions.push_back(moved(bench, 0));
        costs.push_back(bench.emulated->costs());
    }
    EXPECT_EQ(motions[0].recording.values, motions[1].recording.values);
    EXPECT_EQ(motions[0].recording.time_s, motions[1].recording.time_s);
    EXPECT_EQ(motions[0].parameters, motions[1].parameters);
    EXPECT_EQ(costs[0].count, costs[1].count);
    EXPECT_EQ(costs[0].worst_instructions, costs[1].worst_instructions);
    EXPECT_EQ(costs[0].total_instructions, costs[1].total_instructions);
}

constexpr std::size_t TravelRows = 500;

bool isTracked(std::size_t travel) {
    return travel / 3 % 2 == 1;
}

/// Share of the rows with a pose by least squares that differ by no more than this.
double shareWithin(const Recording& one, const Recording& other, const std::string& name, double limit) {
    constexpr std::size_t Settling = 50; // behind the change of the estimator
    const std::vector<double> a = one.column(name);
    const std::vector<double> b = other.column(name);
    std::size_t rows = 0;
    std::size_t within = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (!isTracked(i / TravelRows) && i % TravelRows >= Settling) {
            ++rows;
            within += std::abs(a[i] - b[i]) <= limit ? 1U : 0U;
        }
    }
    return static_cast<double>(within) / static_cast<double>(rows);
}

// Random travels with all estimators and allocations for a minute of the board's time, the host's build at
// the same readings beside it.
TEST(Mps2PlanarNight, aMinuteOfTravelsStaysWithTheHostBuildAndWithinTheBudget) {
    constexpr std::size_t Travels = 120;
    constexpr double Budget_instructions = 60000.0;
    const auto readings = std::make_shared<Readings>();
    const auto travel = [](Bench& bench, Recording& recording) {
        Random random(7);
        const auto within = [&random](double limit) { return limit * (2.0 * random.uniform() - 1.0); };
        bench.write({{"hb.home", 1.0}});
        bench.wait(0.01);
        bench.record({"position.x", "position.y", "position.phi", "status", "fault", "chips_left_out"},
                     recording);
        bench.write({{"hb.mode", static_cast<double>(HB_PLANAR_POSITION)}});
        ASSERT_TRUE(bench.device->arm());
        for (std::size_t i = 0; i < Travels; ++i) {
            bench.write({{"coil.allocation", static_cast<double>(i % 3)},
                         {"speed.estimator", isTracked(i) ? 1.0 : 0.0}});
            bench.write({{"hb.setpoint.x", within(0.02)},
                         {"hb.setpoint.y", within(0.02)},
                         {"hb.setpoint.phi", within(0.01)}});
            bench.wait(0.5);
        }
        bench.device->stopStream();
    };
    Recording board;
    Bench emulated = emulatedBench("planar", platenPlant({}, readings), PlanarLine);
    ASSERT_TRUE(emulated.device);
    const auto started = std::chrono::steady_clock::now();
    travel(emulated, board);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - started;
    const TickCosts& costs = emulated.emulated->costs();
    fmt::print("{} ticks, {:.0f} exchanges a second, longest {:.0f}, mean {:.0f} instructions\n", costs.count,
               static_cast<double>(costs.count) / taken.count(), costs.worst_instructions,
               costs.total_instructions / static_cast<double>(costs.count));
    EXPECT_LE(costs.worst_instructions, Budget_instructions);

    Recording host;
    Bench hostBoard = planarHostBench(readings);
    ASSERT_TRUE(hostBoard.device);
    travel(hostBoard, host);
    ASSERT_EQ(board.rows(), host.rows());
    ASSERT_GT(board.rows(), 59000U);
    // Least squares: a phase of up to 12 rad is rounded to 5e-7 rad, which is 4 nm; where the chips say least
    // about one direction (a hundredth of the information of a reading) that counts ten times, and a few such
    // roundings add up. The tracking filter passes its roundings on from tick to tick, in the covariance that
    // makes its gain and in the currents that predict the motion, which only the board's loop corrects: they
    // stay far below what one reading says, whose deviation of 0.3 mT over the slope of 2.5 T/m is 120 um, or
    // 2.4 mrad at the lever of 50 mm.
    for (const auto& [name, usual, rare] :
         {std::tuple{"position.x", 1e-7, 6e-6}, {"position.y", 1e-7, 6e-6}, {"position.phi", 2e-6, 1.2e-4}}) {
        EXPECT_GT(shareWithin(board, host, name, usual), 0.99) << name;
        EXPECT_LT(largestDifference(board, host, name), rare) << name;
    }
    for (const char* name : {"status", "fault", "chips_left_out"}) {
        EXPECT_EQ(board.column(name), host.column(name)) << name;
    }
}

} // namespace
} // namespace halbench::mps2
