#include "control/robustness/batch_simulation.h"
#include "control/robustness/state_powers.h"
#include "tests/control/published_motor.h"

#include <gtest/gtest.h>

#include <numeric>

namespace halbench::control {
namespace {

LoopBatch threeMotors(const PidGains& gains, const LoopTiming& timing) {
    std::vector<PositionPlant> plants{published(), published(), published()};
    plants[1].accelerationGain_rad_s2_A *= 0.8;
    plants[2].dampingRate_1_s *= 1.5;
    return *LoopBatch::make(plants, gains, timing);
}

BatchRun to(double reference_rad, double load_A, std::vector<std::size_t> kept) {
    return {reference_rad, load_A, 1, std::move(kept)};
}

// Second route: every sample one after the other, as the points between keep it from leaping. A leap of 2^13
// samples is 13 squarings; each doubles the rounding of the map, so that 1e-16 * 2^13 is left, times the few
// that the motion adds.
TEST(StatePowers, endWhereTheSamplesEnd) {
    constexpr double Rounding = 1e-11;
    const std::vector<std::size_t> far{0, 63, 200, 5000, 13193, 20000};
    PidGains slow = recommended();
    slow.proportional *= 0.02;
    slow.integral *= 1e-4;
    slow.derivative *= 0.1;
    for (const int delay : {0, 1, 3}) {
        for (const PidGains& gains : {recommended(), slow}) {
            const LoopBatch batch = threeMotors(gains, {0.002, delay});
            std::vector<std::size_t> near(far.back() + 1);
            std::iota(near.begin(), near.end(), 0U);
            BatchCurves leapt(LaneWidth, 6), stepped(LaneWidth, static_cast<Eigen::Index>(near.size()));
            runBatch(batch, 0, to(1.0, 0.3, far), leapt, 0);
            runBatch(batch, 0, to(1.0, 0.3, near), stepped, 0);
            for (int i = 0; i < 6; ++i) {
                for (int lane = 0; lane < 3; ++lane) {
                    EXPECT_NEAR(leapt(lane, i), stepped(lane, static_cast<Eigen::Index>(far[i])), Rounding)
                        << "delay " << delay << " point " << far[i] << " lane " << lane;
                }
            }
        }
    }
}

TEST(StatePowers, ofAnUnstableLoopLeadOutOfTheNumbersToo) {
    PidGains gains = recommended();
    gains.proportional *= 100.0;
    const LoopBatch batch = threeMotors(gains, {0.01, 0});
    BatchCurves curves(3, 2);
    runBatch(batch, 0, to(1.0, 0.0, {0, 90000}), curves, 0);
    EXPECT_TRUE(finiteLanes(curves).empty());
}

TEST(StatePowers, areWorthTheMoreTheFewerCurrentsWait) {
    EXPECT_EQ(StatePowers::shortest(0), 64U);
    EXPECT_GT(StatePowers::shortest(15), 300U);
}

} // namespace
} // namespace halbench::control
