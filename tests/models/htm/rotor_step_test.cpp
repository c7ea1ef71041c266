#include "control/base/random.h"
#include "models/htm/rotor_step.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::models {
namespace {

constexpr double Step_s = 2.5e-4;

// One step of the whole time is the second route: friction that is the same everywhere makes the motion exact
// for any duration, stops and starts within it included. The tolerance is that of 200 sums rounded to 1e-16.
TEST(RotorStepTest, manyStepsAreOneOfTheWholeTime) {
    Random random(41);
    int stopped = 0;
    for (int motor = 0; motor < 300; ++motor) {
        RotorConfig config;
        config.viscousDamping_Nm_s = motor % 4 == 0 ? 0.0 : 0.02 * random.uniform();
        config.staticFriction_ratio = 1.0 + random.uniform();
        config.asymmetry_ratio = 0.2 * random.uniform() - 0.1;
        const RotorStep step(config, Step_s);
        const double torque_Nm = 0.1 * random.uniform() - 0.05;
        RotorState often{0.0, 40.0 * random.uniform() - 20.0, 1.0};
        RotorState once = often;
        for (int i = 0; i < 200; ++i) {
            step.move(often, torque_Nm);
        }
        RotorStep(config, 200 * Step_s).move(once, torque_Nm);
        EXPECT_NEAR(often.angle_rad, once.angle_rad, 1e-12) << motor;
        EXPECT_NEAR(often.speed_rad_s, once.speed_rad_s, 1e-11) << motor;
        stopped += once.speed_rad_s == 0.0;
    }
    EXPECT_GT(stopped, 10);
}

// Without torque and dry friction: omega e^(-c t/J).
TEST(RotorStepTest, coastsDownExponentially) {
    RotorConfig config;
    config.coulombFriction_Nm = 0.0;
    RotorState state{0.0, 10.0, 1.0};
    const RotorStep step(config, Step_s);
    for (int i = 0; i < 4000; ++i) {
        step.move(state, 0.0);
    }
    const double rate_per_s = config.viscousDamping_Nm_s / config.inertia_kg_m2;
    EXPECT_NEAR(state.speed_rad_s, 10.0 * std::exp(-rate_per_s), 1e-12);
    EXPECT_NEAR(state.angle_rad, 10.0 * (1.0 - std::exp(-rate_per_s)) / rate_per_s, 1e-11);
}

// Counting the energy changes no bit of the motion, and the kinetic energy is what is left of it.
TEST(RotorStepTest, countedEnergyIsThatOfTheMotion) {
    RotorConfig config;
    config.perTurn_ratio = 0.1;
    const RotorStep step(config, Step_s);
    RotorState counted;
    RotorState moved;
    Random random(7);
    double balance_J = 0.0;
    for (int i = 0; i < 4000; ++i) {
        const double torque_Nm = i % 50 < 25 ? 0.2 * random.uniform() - 0.1 : 0.0;
        const RotorEnergy energy = step.moveCounted(counted, torque_Nm);
        step.move(moved, torque_Nm);
        balance_J += energy.electricalWork_J - energy.frictionLoss_J - energy.viscousLoss_J;
        ASSERT_EQ(counted.angle_rad, moved.angle_rad);
        ASSERT_EQ(counted.speed_rad_s, moved.speed_rad_s);
    }
    EXPECT_NEAR(balance_J, kineticEnergy_J(config, moved), 1e-12); // 4000 sums of some 1e-4 J
}

} // namespace
} // namespace halbench::models
