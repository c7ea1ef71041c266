#include "control/robustness/simulated_ensemble.h"
#include "tests/control/published_motor.h"

#include <gtest/gtest.h>

namespace halbench::control {
namespace {

// The board's law can stop and go on; started anew for each part it makes the same steps. Every third motor
// is so strong that its loop leaves all numbers on the way.
TEST(SimulatedEnsemble, runFromTheBeginningForEachPartTheBandIsTheSameToItsLastBit) {
    PidGains gains;
    gains.proportional = 4.0;
    gains.derivative = 0.4;
    std::vector<PositionPlant> plants(50, published());
    for (std::size_t i = 0; i < plants.size(); ++i) {
        plants[i].accelerationGain_rad_s2_A *= i % 3 == 0 ? 60.0 : 0.9 + 0.004 * static_cast<double>(i);
    }
    const auto batch = LoopBatch::make(plants, gains, {0.01, 1});
    ASSERT_TRUE(batch);
    const SimulatedEnsemble motors = simulatedEnsemble(*batch);
    EXPECT_EQ(motors.count, 50U);
    EXPECT_EQ(motors.period_s, 0.01);
    const BatchRun run{1.0, 0.3, 2, keptPoints(12001, 12001)};
    const auto whole = motors.middle(run);
    ASSERT_TRUE(whole);
    ASSERT_EQ(whole->p5.size(), 12001U);
    for (const std::size_t mostValues : {std::size_t(600050), std::size_t(300000), std::size_t(100001)}) {
        const auto parts = middleByParts(motors, run, mostValues);
        ASSERT_TRUE(parts);
        EXPECT_EQ(parts->p5, whole->p5) << mostValues;
        EXPECT_EQ(parts->p95, whole->p95) << mostValues;
    }
}

TEST(SimulatedEnsemble, whereNoneStaysWithinNumbersThereIsNoBand) {
    PidGains gains;
    gains.proportional = 400.0;
    const auto batch = LoopBatch::make({published()}, gains, {0.01, 1});
    ASSERT_TRUE(batch);
    const BatchRun run{1.0, 0.0, 1, keptPoints(12001, 12001)};
    EXPECT_FALSE(middleByParts(simulatedEnsemble(*batch), run));
    EXPECT_FALSE(middleByParts(simulatedEnsemble(*batch), run, 100));
}

} // namespace
} // namespace halbench::control
