#include "control/base/random.h"
#include "control/base/units.h"
#include "models/htm/htm_linear.h"
#include "models/htm/htm_rotor.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::models {
namespace {

constexpr double Phi = 1.43e-2;

TEST(HtmRotor, staysBitIdenticalAtRestBelowTheStaticLevel) {
    RotorConfig config;
    config.staticFriction_ratio = 1.15;
    for (const double torque : {0.0, 2.05e-2, -2.05e-2, 1.15 * 2.05e-2, -1.15 * 2.05e-2}) {
        RotorState state{0.123456789, 0.0, 1.0};
        for (int i = 0; i < 10000; ++i) {
            stepRotor(config, state, torque, 0.37e-3);
        }
        stepRotor(config, state, torque, 1e6);
        EXPECT_EQ(state.angle_rad, 0.123456789);
        EXPECT_EQ(state.speed_rad_s, 0.0);
    }
}

TEST(HtmRotor, leavesRestInTheDirectionOfATorqueAboveTheStaticLevel) {
    RotorConfig config;
    RotorState state;
    stepRotor(config, state, -2.05e-2 * (1.0 + 1e-9), 0.01);
    EXPECT_LT(state.angle_rad, 0.0);
}

TEST(HtmRotor, acceleratesFromRestAsDerivedAtFourAmperes) {
    RotorState state;
    stepRotor(RotorConfig{}, state, 4.0 * Phi, 1e-7);
    EXPECT_NEAR(state.speed_rad_s / 1e-7, 66.73, 0.005); // last printed digit of section 2
}

TEST(HtmRotor, coastsDownInThePublishedTime) {
    // t_stop = (1/a) ln(1 + a omega0/f) = 0.4436 s from 270 r/min (section 7.3)
    const double omega0 = 270.0 * 3.14159265358979323846 / 30.0;
    const RotorConfig config;
    const HtmLinearPlant plant = linearize(config, Phi);
    const double a = plant.rate_per_s;
    const double f = plant.friction_rad_per_s2;
    const double stop_s = std::log1p(a * omega0 / f) / a;
    EXPECT_NEAR(stop_s, 0.4436, 5e-5);
    RotorState before{0.0, omega0, 1.0};
    stepRotor(config, before, 0.0, stop_s * (1.0 - 1e-9));
    EXPECT_GT(before.speed_rad_s, 0.0);
    RotorState after{0.0, omega0, 1.0};
    stepRotor(config, after, 0.0, 10.0);
    EXPECT_EQ(after.speed_rad_s, 0.0);
    const double travel_rad = -(f / a) * stop_s + (omega0 + f / a) * (1.0 - std::exp(-a * stop_s)) / a;
    EXPECT_NEAR(after.angle_rad, travel_rad, 1e-12 * travel_rad * 100);
}

TEST(HtmRotor, followsTheClosedFormWhileItMoves) {
    const RotorConfig config;
    const double torque = 3.0 * Phi;
    const double a = config.viscousDamping_Nm_s / config.inertia_kg_m2;
    const double w_inf = (torque - config.coulombFriction_Nm) / config.viscousDamping_Nm_s;
    for (const double t : {1e-4, 1e-2, 0.0279, 0.0280, 0.3, 3.0}) { // both sides of the series' border
        RotorState state{0.0, 1.5, 1.0};
        stepRotor(config, state, torque, t);
        EXPECT_NEAR(state.speed_rad_s, w_inf + (1.5 - w_inf) * std::exp(-a * t), 1e-12 * w_inf);
        EXPECT_NEAR(state.angle_rad, w_inf * t + (1.5 - w_inf) * (1.0 - std::exp(-a * t)) / a, 1e-11);
    }
}

TEST(HtmRotor, isConstantAccelerationWithoutViscousFriction) {
    RotorConfig config;
    config.viscousDamping_Nm_s = 0.0;
    RotorState state{0.0, 2.0, 1.0};
    const double torque = 3e-2;
    const double acceleration = (torque - config.coulombFriction_Nm) / config.inertia_kg_m2;
    stepRotor(config, state, torque, 0.5);
    EXPECT_NEAR(state.speed_rad_s, 2.0 + 0.5 * acceleration, 1e-13 * 20);
    EXPECT_NEAR(state.angle_rad, 2.0 * 0.5 + 0.125 * acceleration, 1e-13 * 10);
    stepRotor(config, state, 0.0, 100.0);
    EXPECT_EQ(state.speed_rad_s, 0.0); // Coulomb friction alone stops it
}

TEST(HtmRotor, neverStopsWithoutAnyFriction) {
    RotorConfig config;
    config.viscousDamping_Nm_s = 0.0;
    config.coulombFriction_Nm = 0.0;
    RotorState state{0.0, 1.25, 1.0};
    stepRotor(config, state, 0.0, 8.0);
    EXPECT_EQ(state.speed_rad_s, 1.25);
    EXPECT_EQ(state.angle_rad, 10.0);
}

TEST(HtmRotor, reversesThroughAnExactZeroAndGoesOn) {
    // Braked by a torque that exceeds static friction: stops at t_z, then runs the other way.
    const RotorConfig config;
    const double torque = -5e-2;
    const double a = config.viscousDamping_Nm_s / config.inertia_kg_m2;
    const double brake = (torque - config.coulombFriction_Nm) / config.inertia_kg_m2;
    const double stop_s = std::log1p(-a * 3.0 / brake) / a;
    RotorState whole{0.0, 3.0, 1.0};
    stepRotor(config, whole, torque, stop_s + 0.02);
    RotorState second; // the second half alone, from rest
    stepRotor(config, second, torque, 0.02);
    EXPECT_NEAR(whole.speed_rad_s, second.speed_rad_s, 1e-12);
    EXPECT_LT(whole.speed_rad_s, 0.0);
}

TEST(HtmRotor, halvingTheStepChangesNothing) {
    // Property 4 of section 10 at the level of the rotor: constant torque between random changes.
    const RotorConfig config;
    Random random(3);
    RotorState coarse;
    RotorState fine;
    for (int i = 0; i < 500; ++i) {
        const double torque = 6e-2 * (2.0 * random.uniform() - 1.0);
        stepRotor(config, coarse, torque, 0.01);
        stepRotor(config, fine, torque, 0.005);
        stepRotor(config, fine, torque, 0.005);
    }
    EXPECT_NEAR(coarse.angle_rad, fine.angle_rad, 1e-9);
    EXPECT_NEAR(coarse.speed_rad_s, fine.speed_rad_s, 1e-9);
}

TEST(HtmRotor, balancesEnergyInEveryStep) {
    // Property 3: relative to the largest term of the balance; also with every friction option and c = 0.
    Random random(11);
    for (const double damping : {1.23e-3, 0.0}) {
        for (const double stribeck_rad_s : {0.0, 0.3}) {
            RotorConfig config;
            config.viscousDamping_Nm_s = damping;
            config.staticFriction_ratio = 1.15;
            config.asymmetry_ratio = 0.03;
            config.perTurn_ratio = 0.03;
            config.stribeckSpeed_rad_s = stribeck_rad_s;
            RotorState state;
            for (int i = 0; i < 2000; ++i) {
                const double torque = 6e-2 * (2.0 * random.uniform() - 1.0);
                const double step_s = 0.02 * random.uniform();
                const double before_J = kineticEnergy_J(config, state);
                const RotorEnergy energy = stepRotor(config, state, torque, step_s);
                const double after_J = kineticEnergy_J(config, state);
                const double balance_J =
                    energy.electricalWork_J - energy.frictionLoss_J - energy.viscousLoss_J;
                const double scale_J =
                    std::fmax(std::fmax(before_J, after_J), std::fabs(energy.electricalWork_J));
                ASSERT_NEAR(after_J - before_J, balance_J, 1e-9 * scale_J);
                ASSERT_GE(energy.frictionLoss_J, 0.0);
                ASSERT_GE(energy.viscousLoss_J, -1e-18);
            }
        }
    }
}

TEST(HtmRotor, reachesTheSteadySpeedOfTheForceBalance) {
    // Property 8: (phi I - K_f)/c to 1e-9 after 15 s; figure 10's ideal line in r/min (section 5).
    const double current_A[] = {1.5, 2.0, 2.5, 3.0, 3.5, 4.0};
    const double speed_rpm[] = {7.38, 62.89, 118.40, 173.91, 229.42, 284.93};
    const RotorConfig config;
    for (int i = 0; i < 6; ++i) {
        RotorState state;
        for (int step = 0; step < 15000; ++step) {
            stepRotor(config, state, Phi * current_A[i], 1e-3);
        }
        const double expected = (Phi * current_A[i] - config.coulombFriction_Nm) / config.viscousDamping_Nm_s;
        // e^(-15 s / 0.447 s) = 3e-15 is left of the transient
        EXPECT_NEAR(state.speed_rad_s, expected, 1e-9 * expected);
        EXPECT_NEAR(state.speed_rad_s * 30.0 / 3.14159265358979323846, speed_rpm[i], 0.005);
    }
}

TEST(HtmRotor, meetsTheCurrentsOfThePublication) {
    // Section 2: breakaway at 1.43357 A, 111.02 r/min for each further ampere. Section 5: 270 r/min at
    // 3.866 A. Half of the last printed digit.
    const RotorConfig config;
    const auto steady_rpm = [&](double current_A) {
        RotorState state;
        stepRotor(config, state, Phi * current_A, 20.0); // e^(-20 s / 0.447 s) is below rounding
        return radPerSecondToRpm(state.speed_rad_s);
    };
    EXPECT_EQ(steady_rpm(1.43356), 0.0);
    EXPECT_GT(steady_rpm(1.43358), 0.0);
    EXPECT_NEAR(steady_rpm(4.0) - steady_rpm(3.0), 111.02, 0.005);
    EXPECT_NEAR(steady_rpm(3.866), 270.0, 0.0005 * 111.02 + 0.005);
    EXPECT_NEAR(config.viscousDamping_Nm_s * rpmToRadPerSecond(270.0) + config.coulombFriction_Nm, 0.0553,
                5e-5); // section 6.1: the torque that 270 r/min alone need
}

TEST(HtmRotor, frictionDependsOnDirectionAngleAndSpeedAsConfigured) {
    RotorConfig config;
    config.staticFriction_ratio = 1.15;
    config.asymmetry_ratio = 0.03;
    const RotorState still;
    EXPECT_NEAR(kineticFriction_Nm(config, still, 1.0), 2.05e-2 * 1.03, 1e-15);
    EXPECT_NEAR(kineticFriction_Nm(config, still, -1.0), 2.05e-2 * 0.97, 1e-15);
    EXPECT_NEAR(staticFriction_Nm(config, still, 1.0), 2.05e-2 * 1.03 * 1.15, 1e-15);
    config.asymmetry_ratio = 0.0;
    config.perTurn_ratio = 0.03;
    const RotorState quarter{3.14159265358979323846 / 2.0, 0.0, 1.0};
    EXPECT_NEAR(kineticFriction_Nm(config, quarter, 1.0), 2.05e-2 * 1.03, 1e-15);
    config.perTurn_ratio = 0.0;
    config.stribeckSpeed_rad_s = 0.3;
    const RotorState slow{0.0, 0.3, 1.0};
    EXPECT_NEAR(kineticFriction_Nm(config, slow, 1.0), 2.05e-2 * (1.0 + 0.15 * std::exp(-1.0)), 1e-15);
}

TEST(HtmLinear, matchesTheSampledPlantOfThePublication) {
    // Section 3.7, all printed digits.
    const HtmLinearPlant plant = linearize(RotorConfig{}, Phi);
    EXPECT_NEAR(plant.rate_per_s, 2.236364, 5e-7);
    EXPECT_NEAR(plant.gain_rad_per_s2_per_A, 26.0, 1e-12);
    EXPECT_NEAR(plant.friction_rad_per_s2, 37.2727, 5e-5);
    const HtmSampledPlant sampled = samplePlant(plant, 0.01);
    EXPECT_NEAR(sampled.b1_rad_per_A, 1.2903630e-3, 5e-11);
    EXPECT_NEAR(sampled.b2_rad_per_A, 1.2807798e-3, 5e-11);
    EXPECT_NEAR(sampled.decay_ratio, 0.9778846, 5e-8);
}

TEST(HtmLinear, sampledPlantHasItsLimitWithoutDamping) {
    // Double integrator: k Ts^2/2 for both coefficients; and the series joins the closed form.
    const HtmSampledPlant none = samplePlant({0.0, 26.0, 0.0}, 0.01);
    EXPECT_DOUBLE_EQ(none.b1_rad_per_A, 26.0 * 0.5e-4);
    EXPECT_DOUBLE_EQ(none.b2_rad_per_A, 26.0 * 0.5e-4);
    const HtmSampledPlant below = samplePlant({0.99e-2, 26.0, 0.0}, 0.01);
    const HtmSampledPlant above = samplePlant({1.01e-2, 26.0, 0.0}, 0.01);
    EXPECT_NEAR(below.b1_rad_per_A, above.b1_rad_per_A, 1e-9); // slope k Ts^2 x/6: 4e-10 apart
    EXPECT_NEAR(below.b2_rad_per_A, above.b2_rad_per_A, 2e-9);
}

} // namespace
} // namespace halbench::models
