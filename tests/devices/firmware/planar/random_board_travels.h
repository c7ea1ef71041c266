#pragma once

#include "control/base/random.h"
#include "devices/firmware/planar/hb_planar_profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::devices::firmware {

struct BoardMove {
    float distance = 0.0F;
    hb_profile_limits limits{};
};

/// From 10 um to 0.1 m within limits of several decades, every third without one of the jerk.
inline BoardMove randomBoardMove(Random& random) {
    const auto decades = [&random](double from, double to) {
        return static_cast<float>(std::pow(10.0, from + (to - from) * random.uniform()));
    };
    BoardMove move;
    move.distance = (random.uniform() < 0.5 ? -1.0F : 1.0F) * decades(-5.0, -1.0);
    move.limits.speed = decades(-2.0, 0.0);
    move.limits.acceleration = decades(-1.0, 1.0);
    move.limits.jerk = random.uniform() < 0.667 ? decades(0.0, 3.0) : INFINITY;
    return move;
}

/// Follows the travel tick by tick as the board does. Single precision: 2e-6 of the limits, as a dozen
/// operations leave; the time of a tick is rounded by 6e-8 of the travel, which the largest slopes turn into
/// changes. Position, speed and, of the S-curve, acceleration change by no more than that from tick to tick.
/// The end is met to the last bit.
inline void expectBoardTravel(const BoardMove& move) {
    constexpr float Slack = 1.000002F;
    hb_profile profile;
    hb_profile_start(&profile, 0.0F, move.distance, &move.limits);
    const float tick_s = 0.001F + 5e-7F * hb_profile_duration_s(&profile);
    const bool hasJerk = std::isfinite(move.limits.jerk);
    hb_reference_point before = hb_profile_point(&profile);
    ASSERT_EQ(before.value, 0.0F);
    while (profile.running != 0) {
        hb_profile_advance(&profile);
        const hb_reference_point point = hb_profile_point(&profile);
        ASSERT_LE(std::fabs(point.speed), move.limits.speed * Slack);
        ASSERT_LE(std::fabs(point.acceleration), move.limits.acceleration * Slack);
        ASSERT_LE(std::fabs(point.value - before.value),
                  move.limits.speed * tick_s + 4e-6F * std::fabs(move.distance));
        ASSERT_LE(std::fabs(point.speed - before.speed),
                  move.limits.acceleration * tick_s + 4e-6F * move.limits.speed);
        if (hasJerk) {
            ASSERT_LE(std::fabs(point.acceleration - before.acceleration),
                      move.limits.jerk * tick_s + 4e-6F * move.limits.acceleration);
        }
        before = point;
    }
    ASSERT_EQ(before.value, move.distance);
    ASSERT_EQ(before.speed, 0.0F);
    ASSERT_EQ(before.acceleration, 0.0F);
}

inline void expectBoardTravels(std::uint64_t seed, int count) {
    Random random(seed);
    for (int i = 0; i < count && !::testing::Test::HasFatalFailure(); ++i) {
        SCOPED_TRACE(i);
        expectBoardTravel(randomBoardMove(random));
    }
}

} // namespace halbench::devices::firmware
