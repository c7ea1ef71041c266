#include "control/base/random.h"
#include "models/htm/rotor_step.h"

#include <gtest/gtest.h>

namespace halbench::models {
namespace {

// Steps of one length share what depends on the length alone: not a bit may differ, events within a step
// included.
TEST(RotorStepTest, movesAsSingleStepsBitForBit) {
    Random random(41);
    for (int motor = 0; motor < 60; ++motor) {
        RotorConfig config;
        config.viscousDamping_Nm_s = motor % 4 == 0 ? 0.0 : 0.1 * random.uniform();
        config.staticFriction_ratio = 1.0 + random.uniform();
        config.asymmetry_ratio = 0.2 * random.uniform() - 0.1;
        config.perTurn_ratio = motor % 2 == 0 ? 0.0 : 0.1;
        config.stribeckSpeed_rad_s = motor % 3 == 0 ? 2.0 : 0.0;
        const RotorStep step(config, 2.5e-4);
        RotorState single;
        RotorState repeated;
        int rests = 0;
        for (int i = 0; i < 2000; ++i) {
            const double torque_Nm = i % 50 < 25 ? 0.2 * random.uniform() - 0.1 : 0.0;
            stepRotor(config, single, torque_Nm, 2.5e-4);
            step.move(repeated, torque_Nm);
            ASSERT_EQ(single.angle_rad, repeated.angle_rad);
            ASSERT_EQ(single.speed_rad_s, repeated.speed_rad_s);
            rests += single.speed_rad_s == 0.0;
        }
        EXPECT_GT(rests, 100); // it did stop and start
    }
}

} // namespace
} // namespace halbench::models
