#include "control/base/random.h"
#include "control/design/design_methods.h"
#include "control/robustness/robustness.h"
#include "tests/control/published_motor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace halbench::control {
namespace {

UncertainPlant uncertain(double gainDeviation_ratio) {
    UncertainPlant result;
    result.mean = Eigen::Vector2d(2.2363636, 26.0);
    result.covariance = Eigen::MatrixXd::Zero(2, 2);
    result.covariance(1, 1) = std::pow(26.0 * gainDeviation_ratio, 2);
    result.toPlant = [](const Eigen::VectorXd& p) { return PositionPlant{p(0), p(1), 1.4336}; };
    return result;
}

PidGains proportional(double gain) {
    PidGains gains;
    gains.proportional = gain;
    return gains;
}

// The loop is unstable when k is more than 17.27/K_P of nominal: at 17.27 half of the draws.
TEST(Robustness, halfOfTheDrawsAreUnstableAtTheLimit) {
    const double limit = proportionalLimit_A_per_rad(published(), NoDelay);
    const auto robust = assessRobustness(uncertain(0.1), proportional(limit), NoDelay, 4000, Random(3));
    ASSERT_TRUE(robust.has_value());
    EXPECT_NEAR(robust->unstable_fraction, 0.5, 4.0 * 0.5 / std::sqrt(4000.0)); // 4 sigma of the counting
}

// K_P = 10: GM = 1.727/(1 + 0.1 n), so the 5th percentile is at n = +1.645.
TEST(Robustness, fifthPercentileOfTheGainMarginFollowsTheGainOfTheMotor) {
    const auto robust = assessRobustness(uncertain(0.1), proportional(10.0), NoDelay, 4000, Random(3));
    ASSERT_TRUE(robust.has_value());
    const double limit = proportionalLimit_A_per_rad(published(), NoDelay);
    // Counting error of a 5 % quantile: sqrt(0.05 0.95/4000)/density(1.645) = 0.033 sigma.
    EXPECT_NEAR(*robust->gainMargin_ratio_p5, limit / 10.0 / 1.1645, 4.0 * 0.033 * 0.1 * limit / 10.0);
    EXPECT_EQ(robust->draws, 4000);
    ASSERT_TRUE(robust->gainMargin_ratio);
    EXPECT_EQ(robust->gainMargin_ratio->p5, robust->gainMargin_ratio_p5);
    // ... and the 95th at n = -1.645, where the same counting error is stretched by (1.1645/0.8355)^2.
    EXPECT_NEAR(robust->gainMargin_ratio->p95, limit / 10.0 / 0.8355, 4.0 * 0.033 * 0.1 * limit / 10.0 * 2.0);
}

// Of a P loop on this motor a larger gain means a later crossover with less phase: the crossover at n =
// +1.645 belongs to the margins at the other end.
TEST(Robustness, everyMarginHasTheIntervalOfItsMotors) {
    const auto robust = assessRobustness(uncertain(0.1), proportional(10.0), NoDelay, 4000, Random(3));
    ASSERT_TRUE(robust.has_value());
    const auto at = [](double n) {
        PositionPlant plant = published();
        plant.accelerationGain_rad_s2_A *= 1.0 + 0.1 * n;
        return smallestMargins(*sampledOpenLoop(plant, proportional(10.0), NoDelay));
    };
    const StabilityMargins least = at(1.645);
    const StabilityMargins most = at(-1.645);
    ASSERT_TRUE(robust->phaseMargin_deg && robust->delayMargin_s && robust->modulusMargin &&
                robust->gainCrossover_rad_s);
    // 4 counting errors of 0.0033 in the gain of the motor move each of them by less than 3 %.
    constexpr double Counting_ratio = 0.03;
    EXPECT_NEAR(robust->phaseMargin_deg->p5 / least.phaseMargin_deg, 1.0, Counting_ratio);
    EXPECT_NEAR(robust->phaseMargin_deg->p95 / most.phaseMargin_deg, 1.0, Counting_ratio);
    EXPECT_NEAR(robust->delayMargin_s->p5 / least.delayMargin_s, 1.0, Counting_ratio);
    EXPECT_NEAR(robust->delayMargin_s->p95 / most.delayMargin_s, 1.0, Counting_ratio);
    EXPECT_NEAR(robust->modulusMargin->p5 / least.modulusMargin, 1.0, Counting_ratio);
    EXPECT_NEAR(robust->modulusMargin->p95 / most.modulusMargin, 1.0, Counting_ratio);
    EXPECT_NEAR(robust->gainCrossover_rad_s->p5 / *most.gainCrossover_rad_s, 1.0, Counting_ratio);
    EXPECT_NEAR(robust->gainCrossover_rad_s->p95 / *least.gainCrossover_rad_s, 1.0, Counting_ratio);
}

// K_I = 460 has its limits at 0.259 and 3.861 times the gain: some motors are nearer to one, some to the
// other, and a percentile of the signed ratio would say 0.26. Second route: each drawn motor on its own loop.
TEST(Robustness, ofALoopWithTwoLimitsTheNearerOneCountsOnWhicheverSide) {
    PidGains gains = proportional(40.0);
    gains.integral = 460.0;
    gains.derivative = 1.6;
    const auto robust = assessRobustness(uncertain(0.02), gains, NoDelay, 1000, Random(3));
    const auto plants = drawPlants(uncertain(0.02), 1000, Random(3));
    ASSERT_TRUE(robust && plants);
    std::vector<double> nearest;
    int below = 0;
    for (const PositionPlant& plant : *plants) {
        const double ratio = smallestMargins(*sampledOpenLoop(plant, gains, NoDelay)).gainMargin_ratio;
        below += ratio < 1.0 ? 1 : 0;
        nearest.push_back(std::max(ratio, 1.0 / ratio));
    }
    std::sort(nearest.begin(), nearest.end());
    EXPECT_GT(below, 100);
    EXPECT_LT(below, 900);
    EXPECT_LT(robust->gainMargin_ratio_p5, 0.3);
    EXPECT_NEAR(*robust->gainMarginEitherWay_ratio_p5, nearest[50], 2e-3 * nearest[50]); // between two draws
    EXPECT_FALSE(assessRobustness(uncertain(0.02), proportional(30.0), NoDelay, 1000, Random(3))
                     ->gainMarginEitherWay_ratio_p5)
        << "unstable";
}

TEST(Robustness, withoutUncertaintyNoIntervalIsKnown) {
    const auto robust = assessRobustness(uncertain(0.0), proportional(10.0), NoDelay, 1000, Random(3));
    ASSERT_TRUE(robust.has_value());
    EXPECT_FALSE(robust->gainMargin_ratio || robust->phaseMargin_deg || robust->delayMargin_s ||
                 robust->modulusMargin || robust->gainCrossover_rad_s);
}

TEST(Robustness, isTheSameForTheSameSeedAndTightForAMotorKnownExactly) {
    const auto first = assessRobustness(uncertain(0.1), proportional(10.0), NoDelay, 1000, Random(5));
    const auto second = assessRobustness(uncertain(0.1), proportional(10.0), NoDelay, 1000, Random(5));
    EXPECT_EQ(first->phaseMargin_deg_p5, second->phaseMargin_deg_p5);
    const auto exact = assessRobustness(uncertain(0.0), proportional(10.0), NoDelay, 1000, Random(5));
    EXPECT_EQ(exact->unstable_fraction, 0.0);
    EXPECT_NEAR(*exact->gainMargin_ratio_p5, proportionalLimit_A_per_rad(published(), NoDelay) / 10.0,
                1e-6); // bisected
}

// Far beyond its limit a loop may cross with margins that look fine; an unstable draw must not count with
// them.
TEST(Robustness, anUnstableDrawHasNoMargin) {
    const LoopTiming timing{0.01, 2};
    PidGains gains = proportional(5.0);
    gains.derivative = 10.0;
    ASSERT_GT(smallestMargins(*sampledOpenLoop(published(), gains, timing)).phaseMargin_deg, 90.0);
    const auto robust = assessRobustness(uncertain(0.01), gains, timing, 1000, Random(1));
    ASSERT_TRUE(robust.has_value());
    EXPECT_EQ(robust->unstable_fraction, 1.0);
    EXPECT_TRUE(robust->isUncertain);
    EXPECT_FALSE(robust->phaseMargin_deg_p5 || robust->gainMargin_ratio_p5 || robust->gainMargin_ratio ||
                 robust->phaseMargin_deg || robust->modulusMargin);
}

// The sampled gain limit goes with the inverse of the torque constant over J: with the nominal loop at a
// share s of its limit, a draw with (1 + d) times that gain is stable while (1 + d) s < 1, and its margin is
// 1/((1 + d) s), above 1. None of a stable draw is 1 or less, however many others are unstable.
TEST(Robustness, marginsAreThoseOfTheStableDrawsHoweverFewTheyAre) {
    const double limit = proportionalLimit_A_per_rad(published(), NoDelay);
    for (const double share : {0.9, 1.0, 1.1, 1.2}) {
        const auto robust =
            assessRobustness(uncertain(0.1), proportional(share * limit), NoDelay, 4000, Random(5));
        ASSERT_TRUE(robust);
        // share of the normal deviates d/0.1 above (1/share - 1)/0.1, within 4 sigma of the counting
        const double stable = 0.5 * std::erfc(-(1.0 / share - 1.0) / 0.1 / std::sqrt(2.0));
        EXPECT_NEAR(robust->unstable_fraction, 1.0 - stable, 4.0 * 0.5 / std::sqrt(4000.0)) << share;
        ASSERT_TRUE(robust->gainMargin_ratio && robust->phaseMargin_deg && robust->modulusMargin) << share;
        EXPECT_GT(robust->gainMargin_ratio->p5, 1.0) << share;
        EXPECT_GT(robust->phaseMargin_deg->p5, 0.0) << share;
        EXPECT_GT(robust->modulusMargin->p5, 0.0) << share;
        EXPECT_EQ(robust->gainMargin_ratio_p5, robust->gainMargin_ratio->p5);
    }
}

TEST(Robustness, refusesWhatIsNoCovariance) {
    UncertainPlant plant = uncertain(0.1);
    plant.covariance(0, 1) = 100.0;
    plant.covariance(1, 0) = 100.0;
    EXPECT_EQ(assessRobustness(plant, proportional(1.0), NoDelay, 1000, Random(1)).error().code,
              ErrorCode::InvalidInput);
    plant.covariance(0, 1) = std::nan("");
    EXPECT_EQ(assessRobustness(plant, proportional(1.0), NoDelay, 1000, Random(1)).error().code,
              ErrorCode::NotFinite);
    EXPECT_EQ(assessRobustness(uncertain(0.1), proportional(1.0), NoDelay, 10, Random(1)).error().code,
              ErrorCode::OutOfRange);
}

} // namespace
} // namespace halbench::control
