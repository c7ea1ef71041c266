#include "app/procedures/apply/live_apply_plan.h"
#include "app/procedures/apply/live_step_judge.h"
#include "tests/app/procedures/uncertain_motor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace halbench::app {
namespace {

control::PositionLaw law(double kp, double ki, double kd) {
    control::PositionLaw result;
    result.gains.proportional = kp;
    result.gains.integral = ki;
    result.gains.derivative = kd;
    return result;
}

LiveApplyConfig to(const control::PositionLaw& target) {
    LiveApplyConfig config;
    config.target = target;
    config.motor = uncertainMotor(0.02);
    return config;
}

TEST(LiveApplyPlan, goesInASmallNumberOfStepsOfTheAllowedSize) {
    // 10 to 17 by factors of 1.5: 15, then the target itself.
    const auto laws = lawsBetween(law(10.0, 0.0, 0.0), to(law(17.0, 7.0, 0.0)));
    ASSERT_TRUE(laws) << laws.error().message;
    ASSERT_EQ(laws->size(), 2U);
    EXPECT_NEAR(laws->front().gains.proportional, 15.0, 1e-6);
    EXPECT_NEAR(laws->front().gains.integral, 5.0, 1e-6); // on the straight line: five sevenths
    EXPECT_EQ(laws->back(), to(law(17.0, 7.0, 0.0)).target);
}

TEST(LiveApplyPlan, goesDownLikewise) {
    const auto laws = lawsBetween(law(40.0, 60.0, 1.4), to(law(10.0, 0.1, 0.0)));
    ASSERT_TRUE(laws) << laws.error().message;
    double before = 180.0;
    for (const control::PositionLaw& each : *laws) {
        const double now = each.gains.proportional + each.gains.derivative / 0.01;
        EXPECT_LE(before / now, 1.5 + 1e-6);
        before = now;
    }
    EXPECT_EQ(laws->back().gains.proportional, 10.0);
}

TEST(LiveApplyPlan, theSameGainsAreOneStep) {
    const auto laws = lawsBetween(law(10.0, 0.1, 0.0), to(law(10.0, 0.1, 0.0)));
    ASSERT_TRUE(laws);
    EXPECT_EQ(laws->size(), 1U);
}

TEST(LiveApplyPlan, aWayThatDoesNotEndIsRefused) {
    LiveApplyConfig config = to(law(40.0, 0.0, 0.0));
    config.largestStep_ratio = 1.0;
    EXPECT_EQ(lawsBetween(law(10.0, 0.0, 0.0), config).error().code, ErrorCode::OutOfRange);
    config.largestStep_ratio = 1.06;
    EXPECT_EQ(lawsBetween(law(0.1, 0.0, 0.0), config).error().code, ErrorCode::OutOfRange);
    config.target.gains.derivative = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(lawsBetween(law(10.0, 0.0, 0.0), config).error().code, ErrorCode::NotFinite);
}

// A target that is stable can lie behind one that is not: 17.27 A/rad is the limit without derivative, and
// the derivative's share grows from nothing.
TEST(LiveApplyPlan, judgesEverySetOnTheWay) {
    const auto steps = planLiveApply(law(10.0, 0.1, 0.0), to(law(40.0, 60.0, 1.4)));
    ASSERT_TRUE(steps) << steps.error().message;
    for (const LiveStep& step : *steps) {
        EXPECT_LT(step.robust.unstable_fraction, 0.01);
        EXPECT_GT(step.robust.phaseMargin_deg_p5, 0.0);
        ASSERT_EQ(step.band.time_s.size(), step.band.angle_rad.p5.size());
        EXPECT_NEAR(step.band.time_s.back(), 2.0, 1e-9);
    }
    const auto refused = planLiveApply(law(10.0, 0.1, 0.0), to(law(30.0, 0.1, 0.0)));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::Refused);
    EXPECT_NE(refused.error().message.find("step "), std::string::npos);
}

TEST(LiveApplyPlan, anUncertainMotorIsRefusedWhereAKnownOneIsNot) {
    const control::PositionLaw bold = law(12.0, 0.1, 0.0); // a gain margin of 1.44
    LiveApplyConfig config = to(bold);
    config.motor = uncertainMotor(0.005);
    EXPECT_TRUE(planLiveApply(law(10.0, 0.1, 0.0), config));
    config.motor = uncertainMotor(0.2);
    EXPECT_FALSE(planLiveApply(law(10.0, 0.1, 0.0), config));
}

// Who serves a link has a word after each set; what it answers ends the plan.
TEST(LiveApplyPlan, asksBetweenItsSteps) {
    int asked = 0;
    const auto steps = planLiveApply(law(10.0, 0.1, 0.0), to(law(40.0, 60.0, 1.4)), [&asked] {
        ++asked;
        return Result<void>();
    });
    ASSERT_TRUE(steps) << steps.error().message;
    EXPECT_EQ(asked, static_cast<int>(steps->size()));
    const auto ended = planLiveApply(law(10.0, 0.1, 0.0), to(law(40.0, 60.0, 1.4)),
                                     []() -> Result<void> { return failure(ErrorCode::Interrupted, ""); });
    ASSERT_FALSE(ended);
    EXPECT_EQ(ended.error().code, ErrorCode::Interrupted);
}

} // namespace
} // namespace halbench::app
