// Designed gains on the event-exact motor: what the linear prediction promises must hold there.
#include "app/procedures/tune/tune.h"
#include "control/analysis/step_metrics.h"
#include "control/base/units.h"
#include "models/htm/htm_ideal_loop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

struct Motor {
    const char* name;
    double J;
    double c;
    double Kf;
    double phi;
};

/// The published motor and three others, one without friction.
const Motor Motors[] = {{"published", 5.5e-4, 1.23e-3, 2.05e-2, 1.43e-2},
                        {"stronger", 5.5e-4, 2.2e-3, 1.4e-2, 2.1e-2},
                        {"heavier", 1.2e-3, 1.23e-3, 2.05e-2, 2.4e-2},
                        {"frictionless", 5.5e-4, 1.23e-3, 0.0, 1.43e-2}};

MotorEstimate estimateOf(const Motor& motor) {
    MotorEstimate estimate;
    estimate.values = {{"J", motor.J}, {"c", motor.c}, {"Kf", motor.Kf}, {"phi", motor.phi}};
    return estimate;
}

models::IdealLoopConfig idealLoop(const Motor& motor, const control::PositionLaw& law) {
    models::IdealLoopConfig config;
    config.rotor.inertia_kg_m2 = motor.J;
    config.rotor.viscousDamping_Nm_s = motor.c;
    config.rotor.coulombFriction_Nm = motor.Kf;
    config.torqueConstant_Nm_per_A = motor.phi;
    config.law.kp_A_per_rad = law.gains.proportional;
    config.law.ki_A_per_rad_s = law.gains.integral;
    config.law.kd_As_per_rad = law.gains.derivative;
    config.law.inertia_As2_per_rad = law.inertia_A_s2_rad;
    config.law.viscous_As_per_rad = law.viscous_A_s_rad;
    config.law.coulomb_A = law.coulomb_A;
    config.law.coulombSpeed_rad_s = law.coulombSpeed_rad_s;
    config.law.stiction_A = law.stictionCurrent_A;
    config.law.stictionThreshold_rad = law.stictionThreshold_rad;
    config.law.stictionSpeed_rad_s = law.stictionSpeed_rad_s;
    return config;
}

control::PositionLaw recommended(const Motor& motor) {
    return runTune(estimateOf(motor), TuneConfig{})->law;
}

double largestError_deg(const models::IdealTrace& trace, double from_s) {
    double largest_rad = 0.0;
    for (std::size_t i = 0; i < trace.time_s.size(); ++i) {
        if (trace.time_s[i] >= from_s) {
            largest_rad = std::max(largest_rad, std::abs(trace.reference_rad[i] - trace.angle_rad[i]));
        }
    }
    return radiansToDegrees(largest_rad);
}

// The limits of help: htm-theory.md 8.4 for the full chain; the ideal loop must meet them on every motor. The
// overshoot of a step in the current limit depends on the torque that is left to brake: a motor with less of
// it than the published one, (4 A phi + K_f)/J = 141 rad/s^2, overshoots more, and that is said.
TEST(RecommendedGains, bringLargeStepsToRestOnEveryMotor) {
    for (const Motor& motor : Motors) {
        const bool brakesAsWell = (4.0 * motor.phi + motor.Kf) / motor.J > 141.0;
        for (const double step_deg : {100.0, 180.0, 300.0}) {
            models::IdealLoopConfig config = idealLoop(motor, recommended(motor));
            config.reference.amplitude_rad = degreesToRadians(step_deg);
            const models::IdealTrace trace = runIdealLoop(config);
            const auto metrics =
                control::measureStep(trace.time_s, trace.angle_rad, 0.0, config.reference.amplitude_rad);
            ASSERT_TRUE(metrics.has_value());
            EXPECT_LT(metrics->overshoot_percent, brakesAsWell ? 12.0 : 30.0)
                << motor.name << " " << step_deg;
            EXPECT_LT(std::abs(radiansToDegrees(metrics->finalError_rad)), 0.32)
                << motor.name << " " << step_deg;
        }
    }
}

TEST(RecommendedGains, warnOfLargeStepsWhereTheMotorBrakesPoorly) {
    for (const Motor& motor : Motors) {
        const auto tuned = runTune(estimateOf(motor), TuneConfig{});
        const bool isWarned =
            std::any_of(tuned->warnings.begin(), tuned->warnings.end(),
                        [](const Finding& finding) { return finding.code == "large_steps_overshoot"; });
        EXPECT_EQ(isWarned, (4.0 * motor.phi + motor.Kf) / motor.J < 140.0) << motor.name;
    }
}

TEST(RecommendedGains, followASineAndARampOnEveryMotor) {
    for (const Motor& motor : Motors) {
        models::IdealLoopConfig config = idealLoop(motor, recommended(motor));
        config.reference.shape = control::LoopReference::Shape::Sine;
        config.reference.amplitude_rad = degreesToRadians(360.0);
        config.reference.frequency_Hz = 0.2;
        config.duration_s = 10.0;
        EXPECT_LT(largestError_deg(runIdealLoop(config), 5.0), 0.64) << motor.name;
        config.reference = {};
        config.reference.shape = control::LoopReference::Shape::Ramp;
        config.reference.rate_rad_s = degreesToRadians(500.0);
        config.duration_s = 4.0;
        EXPECT_LT(largestError_deg(runIdealLoop(config), 2.0), 0.30) << motor.name;
    }
}

// Second route for the linear prediction: the event-exact motor without friction and without current limit.
TEST(LinearPrediction, isTheMotorWithoutFrictionAndLimit) {
    const Motor& motor = Motors[3];
    for (const char* method : {"recommended", "published", "designed"}) {
        TuneConfig config;
        config.method = method;
        const auto tuned = runTune(estimateOf(motor), config);
        ASSERT_TRUE(tuned.has_value());
        models::IdealLoopConfig loop = idealLoop(motor, tuned->law);
        loop.law.limit_A = 1e6;
        loop.reference.amplitude_rad = 1.0;
        loop.duration_s = 1.0;
        // The board's conditional integration never stops the integral while nothing saturates.
        const models::IdealTrace trace = runIdealLoop(loop);
        for (std::size_t i = 0; i < trace.time_s.size(); ++i) {
            ASSERT_NEAR(tuned->predicted.stepCurve.response_rad[i], trace.angle_rad[i], 1e-9)
                << method << " " << i;
        }
    }
}

// A stable prediction must settle and an unstable one must not, also for delay and other methods.
TEST(LinearPrediction, saysRightlyWhetherTheMotorWithoutFrictionSettles) {
    const Motor& motor = Motors[3];
    const std::pair<const char*, int> cases[] = {
        {"recommended", 0}, {"recommended", 1}, {"recommended", 2}, {"published", 1}, {"micro-step", 0}};
    for (const auto& [method, delay] : cases) {
        TuneConfig config;
        config.method = method;
        config.conditions.timing.delay_samples = delay;
        const auto tuned = runTune(estimateOf(motor), config);
        ASSERT_TRUE(tuned.has_value());
        models::IdealLoopConfig loop = idealLoop(motor, tuned->law);
        loop.law.limit_A = 1e12;
        loop.law.delaySamples = delay;
        loop.reference.amplitude_rad = 1e-3;
        loop.duration_s = 20.0;
        const bool settles = std::abs(runIdealLoop(loop).angle_rad.back() / 1e-3 - 1.0) < 0.5;
        EXPECT_EQ(settles, tuned->predicted.isStable) << method << " " << delay;
    }
}

/// Whether the event-exact motor leaves its place for a reference this far away, which stays.
bool moves(const Motor& motor, control::PositionLaw law, double error_rad) {
    law.gains.integral = 0.0; // with it every rest ends
    models::IdealLoopConfig loop = idealLoop(motor, law);
    loop.reference.amplitude_rad = error_rad;
    loop.duration_s = 0.05;
    return runIdealLoop(loop).angle_rad.back() != 0.0;
}

// The band that is told, against the motion: to 2 % of it.
TEST(FrictionBandOfALaw, isWhereTheMotorRests) {
    for (const char* method : {"recommended", "micro-step", "published"}) {
        const Motor& motor = Motors[0];
        TuneConfig config;
        config.method = method;
        const auto tuned = runTune(estimateOf(motor), config);
        ASSERT_TRUE(tuned.has_value());
        double rests_rad = 0.0;
        double moves_rad = 0.5;
        ASSERT_TRUE(moves(motor, tuned->law, moves_rad)) << method;
        for (int i = 0; i < 40; ++i) {
            const double error_rad = 0.5 * (rests_rad + moves_rad);
            (moves(motor, tuned->law, error_rad) ? moves_rad : rests_rad) = error_rad;
        }
        EXPECT_NEAR(tuned->predicted.frictionBand_rad / rests_rad, 1.0, 0.02) << method;
    }
}

// help: htm-theory.md 6.8: 10 A/deg end in a cycle of 2.0 deg peak to peak in the ideal loop, 10 %; a loop
// that comes to rest from everything has none, and of a law with an assist nothing is said.
TEST(LimitCycles, areToldWithTheTuning) {
    const auto tuned = [](const char* method) {
        TuneConfig config;
        config.method = method;
        return runTune(estimateOf(Motors[0]), config);
    };
    const auto degrees = tuned("published-degrees");
    ASSERT_TRUE(degrees && degrees->cycles);
    const auto swing = std::find_if(degrees->cycles->begin(), degrees->cycles->end(),
                                    [](const PredictedCycle& cycle) { return cycle.isStable; });
    ASSERT_NE(swing, degrees->cycles->end());
    EXPECT_NEAR(2.0 * radiansToDegrees(swing->amplitude_rad), 2.0, 0.2);
    EXPECT_NEAR(swing->accuracy_ratio, 0.5, 1e-12); // what the balance holds off the published motor
    const auto isCycle = [](const Finding& finding) { return finding.code == "limit_cycle"; };
    EXPECT_TRUE(std::any_of(degrees->warnings.begin(), degrees->warnings.end(), isCycle));
    const auto published = tuned("published");
    ASSERT_TRUE(published && published->cycles);
    EXPECT_TRUE(published->cycles->empty());
    EXPECT_FALSE(std::any_of(published->warnings.begin(), published->warnings.end(), isCycle));
    EXPECT_FALSE(tuned("recommended")->cycles.has_value());
}

// From half of the band K_P gives half of what is missing: K_P/K_I seconds, 100 s for the published law.
TEST(LimitCycles, theIntegralEndsARestAfterTheTimeOfItsGains) {
    TuneConfig config;
    config.method = "published";
    EXPECT_NEAR(runTune(estimateOf(Motors[0]), config)->release_s, 10.0 / 0.1, 1e-6);
}

} // namespace
} // namespace halbench::app
