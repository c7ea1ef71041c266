#include "app/procedures/tune/filtered_analysis.h"
#include "app/procedures/tune/loop_law.h"
#include "app/procedures/tune/tune.h"
#include "control/base/units.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

const MotorEstimate Motor{{{"c_over_J", 2.2363636}, {"phi_over_J", 26.0}, {"Kf_over_phi", 1.4336}}, {}, {}};

control::PositionLaw lively() {
    control::PositionLaw law;
    law.gains.proportional = 12.0;
    law.gains.integral = 20.0;
    law.gains.derivative = 0.8;
    return law;
}

control::FilteredLaw filteredOf(const control::PositionLaw& law) {
    control::FilteredLaw filtered;
    filtered.gains = law.gains;
    return filtered;
}

bool has(const TuneResult& result, const std::string& code) {
    return std::any_of(result.warnings.begin(), result.warnings.end(),
                       [&code](const Finding& finding) { return finding.code == code; });
}

// With nothing filtered it is the judgement of the board's law.
TEST(FilteredAnalysis, ofTheBoardsLawSaysWhatItsOwnJudgementSays) {
    const auto board = judgeLaw(Motor, lively(), {});
    const auto filtered = judgeLaw(Motor, {lively(), filteredOf(lively())}, {});
    ASSERT_TRUE(board && filtered) << (filtered ? "" : filtered.error().message);
    EXPECT_EQ(filtered->predicted.margins.phaseMargin_deg, board->predicted.margins.phaseMargin_deg);
    EXPECT_EQ(filtered->predicted.poleRadius, board->predicted.poleRadius);
    EXPECT_EQ(filtered->predicted.frictionBand_rad, board->predicted.frictionBand_rad);
    EXPECT_EQ(filtered->release_s, board->release_s);
    EXPECT_EQ(filtered->predicted.dominantDamping_ratio, board->predicted.dominantDamping_ratio);
    EXPECT_EQ(filtered->robust.unstable_fraction, board->robust.unstable_fraction);
    EXPECT_EQ(filtered->quality.verdict, board->quality.verdict);
    EXPECT_DOUBLE_EQ(filtered->predicted.highFrequencyGain_A_per_rad,
                     board->predicted.highFrequencyGain_A_per_rad);
    ASSERT_TRUE(filtered->disturbance && board->disturbance);
    EXPECT_NEAR(filtered->disturbance->step.peak_rad, board->disturbance->step.peak_rad, 1e-12);
    EXPECT_EQ(filtered->disturbance->step.final_rad, board->disturbance->step.final_rad);
    ASSERT_TRUE(filtered->cycles && board->cycles);
    EXPECT_EQ(filtered->cycles->size(), board->cycles->size());
    ASSERT_TRUE(filtered->predicted.largeStep && board->predicted.largeStep);
    // The law's sums are rounded in another order; friction and limit make 1e-12 of it at most 1e-9.
    EXPECT_NEAR(filtered->predicted.largeStep->metrics.overshoot_percent,
                board->predicted.largeStep->metrics.overshoot_percent, 1e-6);
    ASSERT_TRUE(filtered->predicted.step && board->predicted.step);
    EXPECT_NEAR(filtered->predicted.step->overshoot_percent, board->predicted.step->overshoot_percent, 1e-8);
}

TEST(FilteredAnalysis, figuresAreThoseOfTheFilteredLoop) {
    control::FilteredLaw filtered = filteredOf(lively());
    filtered.proportionalWeight = 0.5;
    filtered.filters = {control::LowPassFilter{120.0, 1}, control::LagFilter{1.0, 2.0}};
    const auto board = judgeLaw(Motor, lively(), {});
    const auto judged = judgeLaw(Motor, {lively(), filtered}, {});
    ASSERT_TRUE(judged && board);
    EXPECT_LT(judged->predicted.margins.phaseMargin_deg, board->predicted.margins.phaseMargin_deg);
    EXPECT_LT(judged->predicted.step->overshoot_percent, board->predicted.step->overshoot_percent);
    EXPECT_TRUE(has(*judged, "needs_filtered_law"));
    EXPECT_EQ(judged->filtered->filters, filtered.filters);
    EXPECT_FALSE(board->filtered);
    // The lag doubles what holds the rotor at rest.
    EXPECT_NEAR(judged->predicted.frictionBand_rad / board->predicted.frictionBand_rad, 0.5, 1e-9);
}

TEST(FilteredAnalysis, anUnstableLoopIsRefusedAndADelaySensitiveOneSaid) {
    control::FilteredLaw filtered = filteredOf(lively());
    filtered.filters = {control::LowPassFilter{10.0, 2}};
    const auto judged = judgeLaw(Motor, {lively(), filtered}, {});
    ASSERT_TRUE(judged);
    EXPECT_FALSE(judged->predicted.isStable);
    EXPECT_EQ(judged->quality.verdict, Verdict::Refused);
    EXPECT_TRUE(has(*judged, "unstable"));
    EXPECT_FALSE(judged->predicted.step);
}

const Finding* findingOf(const TuneResult& result, const std::string& code) {
    const auto found = std::find_if(result.warnings.begin(), result.warnings.end(),
                                    [&code](const Finding& finding) { return finding.code == code; });
    return found == result.warnings.end() ? nullptr : &*found;
}

control::PositionLaw proportional(double kp_A_per_rad) {
    control::PositionLaw law;
    law.gains.proportional = kp_A_per_rad;
    return law;
}

// K_P = 0.025 behind low-passes at 0.02 and 0.05 Hz, of 50 digits (tests/control/law/shaped_delta_test):
// 7.10039904507 deg at 0.159762174765 rad/s and Ms = 9.359. The crossover is below the usual Bode plot. The
// motor's ratios here are the published ones to eight digits.
TEST(FilteredAnalysis, slowFiltersHideNoCrossover) {
    control::FilteredLaw filtered = filteredOf(proportional(0.025));
    filtered.filters = {control::LowPassFilter{2.0 * Pi * 0.02, 1},
                        control::LowPassFilter{2.0 * Pi * 0.05, 1}};
    const auto judged = judgeLaw(Motor, {proportional(0.025), filtered}, {});
    ASSERT_TRUE(judged) << judged.error().message;
    const AnalysisResult& loop = judged->predicted;
    EXPECT_TRUE(loop.isStable);
    EXPECT_NEAR(loop.margins.phaseMargin_deg, 7.1004, 1e-3);
    EXPECT_NEAR(*loop.margins.gainCrossover_rad_s, 0.159762, 1e-5);
    EXPECT_NEAR(1.0 / loop.margins.modulusMargin, 9.359, 1e-2);
    EXPECT_NEAR(loop.margins.gainMargin_ratio, 1.2706, 1e-3);
    EXPECT_NE(judged->quality.verdict, Verdict::Good);
    EXPECT_LT(2.0 * Pi * loop.bode.frequency_Hz.front(), 0.5 * *loop.margins.gainCrossover_rad_s);
    EXPECT_LT(loop.roots.locus.gain.size(), 2000u);
}

TEST(FilteredAnalysis, anUnstableLoopSaysWhichWayItsGainHasToGo) {
    // 100 times the gain of the loop above: the limit is 1.27061140205/100.
    control::FilteredLaw loud = filteredOf(proportional(2.5));
    loud.filters = {control::LowPassFilter{2.0 * Pi * 0.02, 1}, control::LowPassFilter{2.0 * Pi * 0.05, 1}};
    const auto lower = judgeLaw(Motor, {proportional(2.5), loud}, {});
    ASSERT_TRUE(lower);
    EXPECT_NEAR(lower->predicted.margins.gainMargin_ratio, 0.0127061, 1e-6);
    ASSERT_NE(findingOf(*lower, "unstable"), nullptr);
    EXPECT_NE(findingOf(*lower, "unstable")->hint.find("below 0.0127 times"), std::string::npos);

    // K_I/K_P above c/J: no gain is stable (Routh).
    control::PositionLaw fast = proportional(1.0);
    fast.gains.integral = 8.0;
    const auto never = judgeLaw(Motor, fast, {});
    ASSERT_TRUE(never);
    EXPECT_FALSE(never->predicted.stableGains.has_value());
    EXPECT_TRUE(std::isinf(never->predicted.margins.gainMargin_ratio));
    EXPECT_FALSE(never->predicted.margins.phaseCrossover_rad_s.has_value());
    ASSERT_NE(findingOf(*never, "unstable"), nullptr);
    EXPECT_NE(findingOf(*never, "unstable")->hint.find("no common factor"), std::string::npos);

    // With derivative action a weak loop needs more gain.
    control::PositionLaw weak = proportional(0.02);
    weak.gains.integral = 0.2;
    weak.gains.derivative = 0.01;
    const auto raise = judgeLaw(Motor, weak, {});
    ASSERT_TRUE(raise);
    EXPECT_GT(raise->predicted.margins.gainMargin_ratio, 1.0);
    ASSERT_NE(findingOf(*raise, "unstable"), nullptr);
    EXPECT_NE(findingOf(*raise, "unstable")->hint.find("increase them"), std::string::npos);
}

// Where the name of a preset excuses an unstable loop of the board, it does not excuse this one.
TEST(FilteredAnalysis, noPresetHasAnUnstableFilteredLoop) {
    control::FilteredLaw filtered = filteredOf(lively());
    filtered.filters = {control::LowPassFilter{10.0, 2}};
    TuneConfig config;
    config.method = "published";
    EXPECT_EQ(judgeLaw(Motor, {lively(), filtered}, config)->quality.verdict, Verdict::Refused);
}

// The integral's gain at rest is that of the filters too: twice the gain, half of the time.
TEST(FilteredAnalysis, theLawAtRestHasTheFiltersGainForAConstant) {
    control::FilteredLaw filtered = filteredOf(lively());
    filtered.gains.filter_s = 0.004;
    filtered.filters = {control::LagFilter{1.0, 2.0}, control::NotchFilter{180.0, 0.1, 0.5}};
    const control::PositionLaw resting = lawAtRest({lively(), filtered}, 0.01);
    EXPECT_NEAR(resting.gains.proportional, 24.0, 1e-9);
    EXPECT_NEAR(resting.gains.integral, 40.0, 1e-9);
    EXPECT_FALSE(resting.gains.filter_s);
    EXPECT_EQ(lawAtRest(lively(), 0.01), lively());
}

// The gains that count are those of the filtered law, in whatever form.
TEST(FilteredAnalysis, aCheckedLawHasItsGainsInTheParallelForm) {
    control::FilteredLaw filtered;
    filtered.gains.form = control::PidForm::Standard;
    filtered.gains.proportional = 10.0;
    filtered.gains.integral = 0.5;
    filtered.gains.derivative = 0.06;
    filtered.gains.filter_s = 0.004;
    const auto checked = checkedLaw({{}, filtered}, 0.01);
    ASSERT_TRUE(checked);
    EXPECT_NEAR(checked->law.gains.integral, 20.0, 1e-12);
    EXPECT_NEAR(checked->law.gains.derivative, 0.6, 1e-12);
    EXPECT_FALSE(checked->law.gains.filter_s);
    EXPECT_EQ(checked->filtered->gains.filter_s, 0.004);
}

// A step of 100 degrees reaches the limit of 4 A: the filtered law moves the rotor there all the same.
TEST(FilteredAnalysis, theLargeStepRunsThroughTheLimit) {
    control::FilteredLaw filtered = filteredOf(lively());
    filtered.filters = {control::LowPassFilter{150.0, 1}};
    const auto judged = judgeLaw(Motor, {lively(), filtered}, {});
    ASSERT_TRUE(judged && judged->predicted.largeStep);
    const auto& current_A = judged->predicted.largeStep->trace.current_A;
    EXPECT_EQ(*std::max_element(current_A.begin(), current_A.end()), 4.0);
    const auto& angle_rad = judged->predicted.largeStep->trace.angle_rad;
    EXPECT_NEAR(angle_rad.back(), LargeStepHeight_rad, judged->predicted.frictionBand_rad);
}

TEST(FilteredAnalysis, whatIsNoLawIsRefused) {
    control::FilteredLaw filtered = filteredOf(lively());
    filtered.gains.proportional = -1.0;
    EXPECT_EQ(judgeLaw(Motor, {lively(), filtered}, {}).error().code, ErrorCode::OutOfRange);
    filtered = filteredOf(lively());
    filtered.proportionalWeight = 3.0;
    EXPECT_FALSE(judgeLaw(Motor, {lively(), filtered}, {}));
    EXPECT_FALSE(judgeLaw(MotorEstimate(), {lively(), filteredOf(lively())}, {}));
}

} // namespace
} // namespace halbench::app
