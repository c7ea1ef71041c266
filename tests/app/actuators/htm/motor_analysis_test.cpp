#include "app/actuators/htm/motor_analysis.h"
#include "control/base/units.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

// Numbers of resources/help/htm-theory.md sections 4.3, 5 and 6; tolerance: their last digit.

namespace halbench::app {
namespace {

double figure(const MotorAnalysis& analysis, const std::string& key) {
    const auto found = std::find_if(analysis.figures.begin(), analysis.figures.end(),
                                    [&](const ComputedFigure& figure) { return figure.key == key; });
    EXPECT_NE(found, analysis.figures.end()) << key;
    return found == analysis.figures.end() ? std::nan("") : found->value;
}

TEST(TorqueAnalysis, setsThePublishedFiguresAgainstTheTorqueConstant) {
    const MotorAnalysis analysis = analyseTorque({}, {rpmToRadPerSecond(270.0), 0.044});
    EXPECT_NEAR(figure(analysis, "largest_torque"), 0.0572, 5e-5);
    EXPECT_NEAR(figure(analysis, "speed_torque"), 0.0553, 5e-5);
    EXPECT_NEAR(figure(analysis, "torque_current"), 3.08, 5e-3);
    EXPECT_NEAR(figure(analysis, "steady_speed"), 284.9, 0.05);
    EXPECT_NEAR(figure(analysis, "speed_current"), 3.866, 5e-4);
    EXPECT_EQ(analysis.quality.verdict, Verdict::Good);
}

TEST(TorqueAnalysis, hasNoSteadySpeedWithoutDampingAndNoAnswerWithoutAQuestion) {
    models::HtmParameters motor;
    motor.viscousDamping_Nm_s = 0.0;
    const MotorAnalysis analysis = analyseTorque(motor, {});
    EXPECT_EQ(analysis.figures.size(), 2U); // current and torque
}

TEST(SensingAnalysis, countsGrowCoarserAsTheSensorsSensitivityFalls) {
    const MotorAnalysis cold = analyseSensing({}, 25.0);
    EXPECT_NEAR(figure(cold, "field_step"), 0.3906, 5e-5);
    EXPECT_NEAR(figure(cold, "angle_step_linear"), 0.1583, 5e-5);
    EXPECT_NEAR(figure(cold, "angle_step_arctangent"), 0.1426, 5e-5);
    EXPECT_NEAR(figure(cold, "stray_angle_linear"), 4.05, 5e-3);
    EXPECT_NEAR(figure(cold, "stray_angle_arctangent"), 3.64, 5e-3);
    EXPECT_NEAR(figure(cold, "current_step"), 2.4414, 5e-5);
    EXPECT_NEAR(figure(analyseSensing({}, 80.0), "field_step"), 0.3664, 5e-5);
}

TEST(PolesAnalysis, givesTheGainsOfThePublishedTargetsAndThePolesOfThePrintedGains) {
    PolesQuestion question;
    question.gains.proportional = 10.0;
    question.gains.integral = 0.1;
    question.rampRate_rad_s = degreesToRadians(500.0);
    question.accuracy_rad = degreesToRadians(0.64);
    const Result<MotorAnalysis> analysis = analysePoles({}, question);
    ASSERT_TRUE(analysis.has_value()) << analysis.error().message;
    EXPECT_NEAR(figure(*analysis, "designed_kp"), 8.684, 5e-4);
    EXPECT_NEAR(figure(*analysis, "designed_ki"), 3.776, 5e-4);
    EXPECT_NEAR(figure(*analysis, "slow_pole"), -0.0100, 5e-5);
    EXPECT_NEAR(figure(*analysis, "pair_frequency"), 16.12, 5e-3);
    EXPECT_NEAR(figure(*analysis, "pair_damping"), 0.0690, 5e-5);
    EXPECT_NEAR(figure(*analysis, "kp_limit"), 17.27, 5e-3);
    EXPECT_NEAR(figure(*analysis, "friction_band"), 8.21, 5e-3);
    EXPECT_NEAR(figure(*analysis, "rest_gain"), 2.24, 5e-3);
    EXPECT_NEAR(figure(*analysis, "ramp_gain"), 3.41, 5e-3);
    EXPECT_NEAR(figure(*analysis, "ramp_lag"), 12.5, 0.05);
    EXPECT_NEAR(figure(*analysis, "smallest_ramp_lag"), 7.2, 0.05);
    question.accuracy_rad = degreesToRadians(0.32); // one micro-step
    EXPECT_NEAR(figure(*analysePoles({}, question), "rest_gain"), 4.48, 5e-3);
}

TEST(PolesAnalysis, refusesTargetsThatTheMotorCannotMeet) {
    PolesQuestion question;
    question.gains.proportional = 10.0;
    question.targets.zeta = 0.5; // at most 0.0745 at 15 rad/s, section 3.6
    const Result<MotorAnalysis> analysis = analysePoles({}, question);
    ASSERT_FALSE(analysis.has_value());
    EXPECT_EQ(analysis.error().code, ErrorCode::OutOfRange);
}

} // namespace
} // namespace halbench::app
