#include "app/procedures/judge_shaped.h"
#include "app/procedures/loop_prediction.h"
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

control::ShapedLaw shapedOf(const control::PositionLaw& law) {
    control::ShapedLaw shaped;
    shaped.gains = law.gains;
    return shaped;
}

bool has(const TuneResult& result, const std::string& code) {
    return std::any_of(result.warnings.begin(), result.warnings.end(),
                       [&code](const Finding& finding) { return finding.code == code; });
}

// With nothing shaped it is the judgement of the board's law.
TEST(JudgeShaped, ofTheBoardsLawSaysWhatItsOwnJudgementSays) {
    const auto board = judgeLaw(Motor, lively(), {});
    const auto shaped = judgeShaped(Motor, shapedOf(lively()), lively(), {});
    ASSERT_TRUE(board && shaped) << (shaped ? "" : shaped.error().message);
    EXPECT_EQ(shaped->predicted.margins.phaseMargin_deg, board->predicted.margins.phaseMargin_deg);
    EXPECT_EQ(shaped->predicted.poleRadius, board->predicted.poleRadius);
    EXPECT_EQ(shaped->predicted.frictionBand_rad, board->predicted.frictionBand_rad);
    EXPECT_EQ(shaped->release_s, board->release_s);
    EXPECT_EQ(shaped->predicted.dominantDamping_ratio, board->predicted.dominantDamping_ratio);
    EXPECT_EQ(shaped->robust.unstable_fraction, board->robust.unstable_fraction);
    EXPECT_EQ(shaped->quality.verdict, board->quality.verdict);
    EXPECT_DOUBLE_EQ(shaped->predicted.highFrequencyGain_A_per_rad,
                     board->predicted.highFrequencyGain_A_per_rad);
    ASSERT_TRUE(shaped->predicted.step && board->predicted.step);
    EXPECT_NEAR(shaped->predicted.step->overshoot_percent, board->predicted.step->overshoot_percent, 1e-8);
}

TEST(JudgeShaped, figuresAreThoseOfTheShapedLoopAndWhatIsNotPredictedIsAbsent) {
    control::ShapedLaw shaped = shapedOf(lively());
    shaped.proportionalWeight = 0.5;
    shaped.filters = {control::LowPassFilter{120.0, 1}, control::LagFilter{1.0, 2.0}};
    const auto board = judgeLaw(Motor, lively(), {});
    const auto judged = judgeShaped(Motor, shaped, lively(), {});
    ASSERT_TRUE(judged && board);
    EXPECT_LT(judged->predicted.margins.phaseMargin_deg, board->predicted.margins.phaseMargin_deg);
    EXPECT_LT(judged->predicted.step->overshoot_percent, board->predicted.step->overshoot_percent);
    EXPECT_TRUE(has(*judged, "not_on_board"));
    EXPECT_FALSE(judged->cycles || judged->disturbance || judged->predicted.largeStep);
    // The lag doubles what holds the rotor at rest.
    EXPECT_NEAR(judged->predicted.frictionBand_rad / board->predicted.frictionBand_rad, 0.5, 1e-9);
}

TEST(JudgeShaped, anUnstableLoopIsRefusedAndADelaySensitiveOneSaid) {
    control::ShapedLaw shaped = shapedOf(lively());
    shaped.filters = {control::LowPassFilter{10.0, 2}};
    const auto judged = judgeShaped(Motor, shaped, lively(), {});
    ASSERT_TRUE(judged);
    EXPECT_FALSE(judged->predicted.isStable);
    EXPECT_EQ(judged->quality.verdict, Verdict::Refused);
    EXPECT_TRUE(has(*judged, "unstable"));
    EXPECT_FALSE(judged->predicted.step);
}

TEST(JudgeShaped, whatIsNoLawIsRefused) {
    control::ShapedLaw shaped = shapedOf(lively());
    shaped.gains.proportional = -1.0;
    EXPECT_EQ(judgeShaped(Motor, shaped, lively(), {}).error().code, ErrorCode::OutOfRange);
    shaped = shapedOf(lively());
    shaped.proportionalWeight = 3.0;
    EXPECT_FALSE(judgeShaped(Motor, shaped, lively(), {}));
    EXPECT_FALSE(judgeShaped(MotorEstimate(), shapedOf(lively()), lively(), {}));
}

} // namespace
} // namespace halbench::app
