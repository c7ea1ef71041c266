#include "devices/firmware/planar/hb_planar_profile.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::devices::firmware {
namespace {

TEST(PlanarProfile, keepsItsLimitsAndArrivesAtRest) {
    struct Case {
        float distance, speed, acceleration;
        double duration_s; ///< d/v + v/a, or 2 sqrt(d/a) for a triangle
    };
    const Case cases[] = {{0.05F, 0.10512F, 0.438F, 0.05 / 0.10512 + 0.24},
                          {-0.05F, 0.16252F, 0.956F, 0.05 / 0.16252 + 0.17},
                          {0.002F, 1.0F, 0.5F, 2.0 * std::sqrt(0.002 / 0.5)}};
    for (const Case& c : cases) {
        hb_profile profile;
        hb_profile_start(&profile, 0.01F, c.distance, c.speed, c.acceleration);
        EXPECT_NEAR(static_cast<double>(hb_profile_duration_s(&profile)), c.duration_s, 1e-6);
        hb_reference_point previous = hb_profile_point(&profile);
        EXPECT_FLOAT_EQ(previous.value, 0.01F);
        int ticks = 0;
        for (; profile.running != 0 && ticks < 10000; ++ticks) {
            hb_profile_advance(&profile);
            const hb_reference_point point = hb_profile_point(&profile);
            // Trapezoid rule over a tick: exact but for the tick that a corner of the speed falls into.
            const float step = 0.0005F * (previous.speed + point.speed);
            ASSERT_NEAR(point.value - previous.value, step, c.acceleration * 0.3e-6F + 1e-8F) << ticks;
            ASSERT_LE(std::fabs(point.speed), c.speed * 1.00001F);
            ASSERT_LE(std::fabs(point.acceleration), c.acceleration * 1.00001F);
            previous = point;
        }
        EXPECT_NEAR(1e-3 * ticks, c.duration_s, 1e-3);
        EXPECT_FLOAT_EQ(previous.value, 0.01F + c.distance);
        EXPECT_EQ(previous.speed, 0.0F);
    }
}

TEST(PlanarProfile, withoutLimitsDoesNotMove) {
    hb_profile profile;
    hb_profile_start(&profile, 0.01F, 0.05F, 0.0F, 1.0F);
    EXPECT_EQ(profile.running, 0);
    EXPECT_FLOAT_EQ(hb_profile_point(&profile).value, 0.01F);
}

} // namespace
} // namespace halbench::devices::firmware
