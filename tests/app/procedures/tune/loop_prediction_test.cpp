#include "app/procedures/tune/disturbance.h"
#include "app/procedures/tune/loop_prediction.h"
#include "app/procedures/tune/tune.h"
#include "control/assess/load_step.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

MotorEstimate motor(double damping_Nm_s = 1.23e-3) {
    MotorEstimate estimate;
    estimate.values = {{"J", 5.5e-4}, {"c", damping_Nm_s}, {"Kf", 2.05e-2}, {"phi", 1.43e-2}};
    return estimate;
}

control::PositionLaw gains(double proportional, double integral, double derivative) {
    control::PositionLaw law;
    law.gains.proportional = proportional;
    law.gains.integral = integral;
    law.gains.derivative = derivative;
    return law;
}

Result<AnalysisResult> analysed(const control::PositionLaw& law, double period_s) {
    LoopConditions conditions;
    conditions.timing.period_s = period_s;
    return runAnalysis(motor(), law, conditions);
}

// 2000 samples were the most that was looked at: 1 s at 0.5 ms. Expected: the same difference equations,
// iterated by a program of its own over 12 s.
TEST(StepHorizon, slowLoopsWithFastSamplingAreSeenToTheirEnd) {
    const auto half = analysed(gains(10.0, 5.0, 3.0), 5e-4);
    ASSERT_TRUE(half && half->step);
    EXPECT_NEAR(half->step->overshoot_percent, 9.866, 0.005);
    EXPECT_NEAR(half->step->peakTime_s.value(), 1.405, 0.005);
    EXPECT_NEAR(half->step->settlingTime_s.value(), 4.41, 0.01);
    const auto weak = analysed(gains(2.0, 0.5, 0.5), 5e-4);
    ASSERT_TRUE(weak && weak->step);
    EXPECT_NEAR(weak->step->overshoot_percent, 6.02, 0.01);
    const auto stiff = analysed(gains(20.0, 15.0, 4.0), 1e-3);
    ASSERT_TRUE(stiff && stiff->step);
    EXPECT_NEAR(stiff->step->settlingTime_s.value(), 2.93, 0.01);
    EXPECT_LE(half->stepCurve.time_s.size(), 100001U);
}

// Poles of up to 333 samples: as it was, six time constants in ten points a sample.
TEST(StepHorizon, usualLoopsKeepTheirs) {
    const auto usual = analysed(gains(40.0, 60.0, 1.4), 0.01);
    ASSERT_TRUE(usual && usual->step);
    const double six_s = -6.0 / std::log(usual->poleRadius) * 0.01;
    EXPECT_NEAR(usual->stepCurve.time_s.back(), std::max(six_s, 1.0), 2e-3);
    EXPECT_EQ(stepPointsPerSample(20.0, 0.01), 10);
    EXPECT_EQ(stepPointsPerSample(200.0, 0.01), 1);
}

// The file of a step has both answers in one table.
TEST(StepHorizon, aSlowLoopsLoadHasTheTimesOfItsStep) {
    LoopConditions conditions;
    conditions.timing.period_s = 5e-4;
    const auto law = gains(10.0, 5.0, 3.0);
    const auto slow = runAnalysis(motor(), law, conditions);
    ASSERT_TRUE(slow);
    ASSERT_LT(slow->stepCurve.pointsPerSample, 10);
    const auto load = disturbanceStep(motor(), law, conditions, *slow);
    ASSERT_TRUE(load);
    EXPECT_EQ(load->time_s, slow->stepCurve.time_s);
}

// Too slow for any horizon: withheld, and said.
TEST(StepHorizon, whatCannotBeSeenToItsPeakIsWithheld) {
    AnalysisResult result;
    result.isStable = true;
    result.poleRadius = 1.0 - 1e-8;
    result.roots.closedLoop = {{1.0 - 1e-8, 1e-9}, {1.0 - 1e-8, -1e-9}};
    EXPECT_FALSE(stepExtent(result, 0.01).hasPeaks);
    result.step = control::StepMetrics{};
    withholdStep(result);
    EXPECT_FALSE(result.step);
    ASSERT_EQ(result.warnings.size(), 1U);
    EXPECT_EQ(result.warnings.front().code, "step_too_long");
    // One slow real pole beside fast ones makes no peak of its own.
    result.roots.closedLoop = {{1.0 - 1e-8, 0.0}, {0.9, 0.0}};
    EXPECT_TRUE(stepExtent(result, 0.01).hasPeaks);
}

// A current that rises slowly, on a motor that hardly turns: 136.4 A/rad after 2 s, 180.9 later, iterated by
// a program of its own.
TEST(StepHorizon, theLargestCurrentIsThatOfTheWholeStep) {
    const auto judged = judgeLaw(motor(10.0), gains(40.0, 60.0, 1.4), TuneConfig{});
    ASSERT_TRUE(judged) << judged.error().message;
    ASSERT_TRUE(judged->assessment);
    EXPECT_NEAR(judged->assessment->peakCurrent_A, 180.89, 0.02);
    EXPECT_NEAR(judged->assessment->largestStep_rad, 4.0 / 180.89, 1e-5);
}

// Without an integral the rotor creeps towards load/K_P from below: that is the most.
TEST(StepHorizon, aLoadThatIsApproachedFromBelowMovesAsFarAsItsEnd) {
    const control::PositionPlant plant{1.23e-3 / 5.5e-4, 26.0, 0.0};
    const auto load = control::loadStep(plant, gains(10.0, 0.0, 3.9).gains, {0.01, 0}, 0.5, 2.0);
    ASSERT_TRUE(load);
    EXPECT_LT(*std::max_element(load->angle_rad.begin(), load->angle_rad.end()), load->final_rad);
    EXPECT_EQ(load->peak_rad, load->final_rad);
}

} // namespace
} // namespace halbench::app
