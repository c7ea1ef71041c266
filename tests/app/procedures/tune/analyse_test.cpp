#include "app/procedures/tune/analyse.h"
#include "app/procedures/tune/large_step.h"
#include "control/base/units.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace halbench::app {
namespace {

constexpr double Nan = std::numeric_limits<double>::quiet_NaN();

MotorEstimate published() {
    MotorEstimate estimate;
    estimate.values = {{"J", 5.5e-4}, {"c", 1.23e-3}, {"Kf", 2.05e-2}, {"phi", 1.43e-2}};
    return estimate;
}

control::PositionLaw recommended() {
    control::PositionLaw law;
    law.gains.proportional = 40.0;
    law.gains.integral = 60.0;
    law.gains.derivative = 1.4;
    return law;
}

TEST(MotorEstimate, refusesSteadySpeedsAloneAndSaysWhatWouldHelp) {
    MotorEstimate estimate;
    estimate.values = {{"c_over_phi", 0.086}, {"Kf_over_phi", 1.43}};
    const auto result = plantFromEstimate(estimate);
    ASSERT_FALSE(result.has_value());
    EXPECT_EQ(result.error().code, ErrorCode::Refused);
    EXPECT_NE(result.error().message.find("phi/J"), std::string::npos);
    EXPECT_NE(result.error().hint.find("--given J"), std::string::npos);
}

TEST(MotorEstimate, completesTheDampingFromTheSlopeOfTheSweep) {
    MotorEstimate estimate;
    estimate.values = {
        {"c_over_phi", 1.23e-3 / 1.43e-2}, {"phi_over_J", 1.43e-2 / 5.5e-4}, {"Kf_over_J", 2.05e-2 / 5.5e-4}};
    const auto plant = plantFromEstimate(estimate);
    ASSERT_TRUE(plant.has_value());
    EXPECT_NEAR(plant->dampingRate_1_s, 1.23e-3 / 5.5e-4, 1e-12);
    EXPECT_NEAR(plant->breakawayCurrent_A, 2.05e-2 / 1.43e-2, 1e-12);
}

TEST(MotorEstimate, completesSteadySpeedsByOneRatioOfATransient) {
    MotorEstimate estimate;
    estimate.values = {{"c_over_phi", 1.23e-3 / 1.43e-2},
                       {"Kf_over_phi", 2.05e-2 / 1.43e-2},
                       {"c_over_J", 1.23e-3 / 5.5e-4}};
    const auto plant = plantFromEstimate(estimate);
    ASSERT_TRUE(plant.has_value());
    EXPECT_NEAR(plant->accelerationGain_rad_s2_A, 26.0, 1e-9);
}

TEST(Analysis, warnsWhereOneMoreSampleOfDelayIsTooMuch) {
    const auto isWarned = [](const control::PositionLaw& law) {
        const auto result = runAnalysis(published(), law, {});
        return std::any_of(result->warnings.begin(), result->warnings.end(),
                           [](const Finding& finding) { return finding.code == "delay_sensitive"; });
    };
    control::PositionLaw printed; // stable without delay, unstable with one sample (htm-theory.md 5)
    printed.gains.proportional = 10.0;
    printed.gains.integral = 0.1;
    EXPECT_TRUE(isWarned(printed));
    EXPECT_FALSE(isWarned(recommended()));
}

TEST(Analysis, curvesCoverTheLoopAlmostToNyquistAndTheStepInMilliseconds) {
    const auto result = runAnalysis(published(), recommended(), {});
    ASSERT_TRUE(result.has_value());
    EXPECT_NEAR(result->bode.frequency_Hz.back(), 49.5, 1e-9);
    ASSERT_EQ(result->bode.phase_deg.size(), result->bode.frequency_Hz.size());
    ASSERT_GT(result->stepCurve.time_s.size(), 2u);
    EXPECT_NEAR(result->stepCurve.time_s[1], 1e-3, 1e-12);
    EXPECT_NEAR(result->stepCurve.current_A.front(), 40.0, 1e-6);
    EXPECT_NEAR(result->stepCurve.response_rad.back(), 1.0, 0.02);
}

/// Near the Nyquist frequency, with eta = pi - omega T, the loop is a delay of one sample, -omega T, and the
/// held rotor's zero at z = -(1 - delta), delta = a T/3, which turns the phase by atan(delta/eta). Each other
/// corner turns it by at most half a radian per e-fold.
TEST(Analysis, phaseHasNoJumpBeforeNyquistThatTheDelayAndTheHeldZeroDoNotExplain) {
    const auto result = runAnalysis(published(), recommended(), {});
    ASSERT_TRUE(result.has_value());
    const auto& bode = result->bode;
    const std::size_t last = bode.phase_deg.size() - 1;
    const double eFolds = std::log(bode.frequency_Hz[last] / bode.frequency_Hz[last - 1]);
    const double corner_deg = 0.5 * eFolds * 180.0 / Pi;
    const auto remaining_rad = [&](std::size_t i) { return Pi * (1.0 - bode.frequency_Hz[i] / 50.0); };
    const double delay_deg = (remaining_rad(last - 1) - remaining_rad(last)) * 180.0 / Pi; // 3.8
    const double delta = 1.23e-3 / 5.5e-4 * 0.01 / 3.0;
    const double zero_deg = (std::atan(delta / remaining_rad(last)) - // 8.9
                             std::atan(delta / remaining_rad(last - 1))) *
                            180.0 / Pi;
    const auto turn_deg = [&](std::size_t i) { return bode.phase_deg[i] - bode.phase_deg[i - 1]; };
    EXPECT_NEAR(turn_deg(last), zero_deg - delay_deg, corner_deg);
    for (std::size_t i = 1; i < last; ++i) {
        // The rotor's lag goes the delay's way, the two zeros of the law and the held zero the other.
        EXPECT_LT(std::abs(turn_deg(i)), delay_deg + corner_deg) << bode.frequency_Hz[i];
    }
}

TEST(Analysis, stepFiguresBelongToTheCurve) {
    const auto result = runAnalysis(published(), recommended(), {});
    const auto& y = result->stepCurve.response_rad;
    const auto peak = std::max_element(y.begin(), y.end());
    EXPECT_NEAR(result->step->overshoot_percent, 100.0 * (*peak - 1.0), 1e-9);
    EXPECT_NEAR(result->step->peakTime_s.value(),
                result->stepCurve.time_s[static_cast<std::size_t>(peak - y.begin())], 1e-12);
}

TEST(Analysis, refusesALawThatIsNoPositionLoop) {
    control::PositionLaw law;
    EXPECT_EQ(runAnalysis(published(), law, {}).error().code, ErrorCode::OutOfRange);
    law.gains.proportional = Nan;
    EXPECT_EQ(runAnalysis(published(), law, {}).error().code, ErrorCode::NotFinite);
    law.gains.proportional = 10.0;
    LoopConditions conditions;
    conditions.currentLimit_A = 0.0;
    EXPECT_EQ(runAnalysis(published(), law, conditions).error().code, ErrorCode::OutOfRange);
}

// K_f/phi over K_P, and 573 A/rad is K_P = 10 A/deg (help: htm-theory.md 6.7, 6.8)
TEST(Analysis, takesGainsInAnyUnit) {
    control::PositionLaw law;
    law.gains.unit = control::GainUnit::PerDegree;
    law.gains.proportional = 10.0;
    const auto result = runAnalysis(published(), law, {});
    ASSERT_TRUE(result.has_value());
    EXPECT_NEAR(result->highFrequencyGain_A_per_rad, 572.958, 0.5e-3);
    EXPECT_NEAR(result->frictionBand_rad, 1.43357 / 572.958, 1e-7);
    EXPECT_FALSE(result->isStable);
}

TEST(Analysis, seesTheDelayOfTheDevice) {
    LoopConditions conditions;
    conditions.timing.delay_samples = 1;
    const auto delayed = runAnalysis(published(), recommended(), conditions);
    const auto prompt = runAnalysis(published(), recommended(), {});
    // One sample at the crossover: 45.7 rad/s 0.01 s = 26.2 deg
    EXPECT_NEAR(prompt->margins.phaseMargin_deg - delayed->margins.phaseMargin_deg, 26.2, 0.1);
    EXPECT_LT(delayed->proportionalLimit_A_per_rad, prompt->proportionalLimit_A_per_rad);
}

// With much derivative action the gain margin is the short one: 26.8 deg, but a factor 1.46.
TEST(Analysis, warnsOfASmallGainMarginBesideAFairPhaseMargin) {
    control::PositionLaw law;
    law.gains.proportional = 5.0;
    law.gains.derivative = 2.152;
    LoopConditions conditions;
    conditions.timing.delay_samples = 1;
    const auto result = runAnalysis(published(), law, conditions);
    ASSERT_TRUE(result.has_value());
    ASSERT_GT(result->margins.phaseMargin_deg, 20.0);
    EXPECT_TRUE(std::any_of(result->warnings.begin(), result->warnings.end(),
                            [](const Finding& finding) { return finding.code == "small_margin"; }));
}

// help: htm-theory.md 8.1
TEST(LargeStep, isTheIdealLoopOfTheTheory) {
    const control::PositionPlant plant = *plantFromEstimate(published());
    control::PositionLaw law;
    law.gains.proportional = 10.0;
    law.gains.integral = 0.1;
    const struct {
        double step_deg;
        double rise_s;
        double overshoot_percent;
        double peak_s;
        double final_deg;
    } table[] = {{100.0, 0.162, 33.3, 0.342, 4.59},
                 {180.0, 0.226, 27.9, 0.455, -2.09},
                 {300.0, 0.305, 22.9, 0.590, -7.08}};
    for (const auto& row : table) {
        const auto step = predictLargeStep(plant, law, {}, degreesToRadians(row.step_deg));
        ASSERT_TRUE(step.has_value());
        EXPECT_NEAR(step->metrics.riseTime_s.value(), row.rise_s, 0.002);
        EXPECT_NEAR(step->metrics.overshoot_percent, row.overshoot_percent, 0.3);
        EXPECT_NEAR(step->metrics.peakTime_s.value(), row.peak_s, 0.002);
        EXPECT_NEAR(radiansToDegrees(step->metrics.finalError_rad), row.final_deg, 0.25);
    }
}

// Expected: steps of 10 us by a program of its own, which are exact to some 1e-4 rad.
TEST(LargeStep, keepsPeriodsThatAreNoWholeMilliseconds) {
    const control::PositionPlant plant = *plantFromEstimate(published());
    control::PositionLaw law;
    law.gains.proportional = 10.0;
    law.gains.integral = 0.1;
    law.gains.derivative = 0.4;
    const struct {
        double period_s;
        double overshoot_percent;
        double final_rad;
    } table[] = {{1e-4, 7.481, -0.13057},
                 {5e-4, 7.499, -0.13089},
                 {1.5e-3, 7.547, -0.13172},
                 {2.5e-3, 7.599, -0.13262},
                 {1.05e-2, 8.158, -0.13714}};
    for (const auto& row : table) {
        LoopConditions conditions;
        conditions.timing.period_s = row.period_s;
        const auto step = predictLargeStep(plant, {law, {}}, conditions, LargeStepHeight_rad);
        ASSERT_TRUE(step.has_value());
        EXPECT_NEAR(step->metrics.overshoot_percent, row.overshoot_percent, 0.02) << row.period_s;
        EXPECT_NEAR(step->metrics.finalError_rad, row.final_rad, 5e-4) << row.period_s;
        EXPECT_TRUE(runAnalysis(published(), {law, {}}, conditions).has_value()) << row.period_s;
    }
    LoopConditions tooFast;
    tooFast.timing.period_s = 1e-6;
    EXPECT_EQ(predictLargeStep(plant, {law, {}}, tooFast, LargeStepHeight_rad).error().code,
              ErrorCode::OutOfRange);
}

bool warnsOf(const AnalysisResult& result, const std::string& code) {
    return std::any_of(result.warnings.begin(), result.warnings.end(),
                       [&code](const Finding& finding) { return finding.code == code; });
}

// Friction breaks away at 1.43 A, and 100 degrees make 0.87 A of 0.5 A/rad: the rotor stays where it is, and
// an integral of 0.01 A/(rad s) adds 0.35 A in 20 s.
TEST(LargeStep, ofARotorThatHasNotArrivedNobodyKnowsTheOvershoot) {
    control::PositionLaw law;
    law.gains.proportional = 0.5;
    law.gains.integral = 0.01;
    law.gains.derivative = 0.1;
    const auto result = runAnalysis(published(), law, {});
    ASSERT_TRUE(result && result->isStable);
    EXPECT_FALSE(result->largeStep->hasArrived());
    EXPECT_FALSE(result->largeStep->overshoot_percent());
    EXPECT_NEAR(result->largeStep->duration_s(), 20.0, 1e-6);
    EXPECT_TRUE(warnsOf(*result, "large_step_not_arrived"));
}

// At its current limit, friction taken off, a motor of much damping has the speed (4 - 1.434) A phi/c for all
// but the last 4 % of the way: 80 % of it take 11.4 s, which 5 s do not show.
TEST(LargeStep, isLookedAtUntilTheRotorHasArrived) {
    MotorEstimate slow = published();
    slow.values["c"] = 0.3;
    control::PositionLaw law;
    law.gains.proportional = 60.0; // friction holds it 1.4 % away
    const auto result = runAnalysis(slow, law, {});
    ASSERT_TRUE(result && result->largeStep);
    const double speed_rad_s = (4.0 - 2.05e-2 / 1.43e-2) * 1.43e-2 / 0.3;
    EXPECT_NEAR(result->largeStep->metrics.riseTime_s.value(), 0.8 * LargeStepHeight_rad / speed_rad_s, 0.03)
        << "it starts within three time constants of J/c = 2 ms, and samples are 10 ms apart";
    EXPECT_TRUE(result->largeStep->hasArrived());
    EXPECT_FALSE(warnsOf(*result, "large_step_not_arrived"));
}

} // namespace
} // namespace halbench::app
