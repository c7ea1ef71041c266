#pragma once

#include "control/base/random.h"
#include "control/signals/travel_profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace halbench::control {

/// Evenly in the logarithm between two powers of ten.
inline double decades(Random& random, double from, double to) {
    return std::pow(10.0, from + (to - from) * random.uniform());
}

struct RandomMove {
    double distance;
    TravelLimits limits;
};

/// From a micrometre to a metre, each limit over several decades: all shapes of the seven pieces occur.
inline RandomMove randomMove(Random& random) {
    RandomMove move;
    move.distance = (random.uniform() < 0.5 ? -1.0 : 1.0) * decades(random, -6.0, 0.0);
    move.limits.speed = decades(random, -3.0, 1.0);
    move.limits.acceleration = decades(random, -2.0, 2.0);
    if (random.uniform() < 0.75) {
        move.limits.jerk = decades(random, -1.0, 4.0);
    }
    return move;
}

/// The instants at which the jerk, or without one the acceleration, changes.
inline std::array<double, 8> cornersOf(const TravelProfile& profile) {
    const double end_s = profile.duration_s();
    const double ramp_s = profile.ramp_s();
    const double jerk_s = profile.jerk() ? profile.peakAcceleration() / *profile.jerk() : 0.0;
    return {0.0,  jerk_s, ramp_s - jerk_s, ramp_s, end_s - ramp_s, end_s - ramp_s + jerk_s, end_s - jerk_s,
            end_s};
}

// The pieces are polynomials: speed, acceleration and jerk are largest at the corners. 1e-10 of the limits
// leave the double precision of a handful of operations three decades of room.
inline void expectLimitsKept(const TravelProfile& profile, const RandomMove& move) {
    constexpr double Slack = 1.0 + 1e-10;
    ASSERT_LE(std::fabs(profile.peakSpeed()), move.limits.speed * Slack);
    ASSERT_LE(std::fabs(profile.peakAcceleration()), move.limits.acceleration * Slack);
    ASSERT_EQ(profile.jerk().has_value(), move.limits.jerk.has_value());
    if (move.limits.jerk) {
        ASSERT_LE(std::fabs(*profile.jerk()), *move.limits.jerk * Slack);
    }
    // The figures are those of the points themselves, but for the rounding of the instant.
    const double rounding_s = 8.0 * std::numeric_limits<double>::epsilon() * profile.duration_s();
    const double rounding = profile.jerk() ? std::fabs(*profile.jerk()) * rounding_s : 0.0;
    for (const double corner_s : cornersOf(profile)) {
        const TravelPoint point = profile.at(corner_s);
        ASSERT_LE(std::fabs(point.speed), move.limits.speed * Slack);
        ASSERT_LE(std::fabs(point.acceleration), move.limits.acceleration * Slack + rounding);
    }
}

// From just before to just behind a corner each quantity changes by its largest slope times the time between
// them and the rounding of both instants, no more: no jump of position, speed and, with a limit of the jerk,
// acceleration. The next derivative may jump.
inline void expectContinuous(const TravelProfile& profile, const RandomMove& move) {
    const double shortest_s = profile.jerk() ? profile.peakAcceleration() / *profile.jerk()
                                             : profile.peakSpeed() / profile.peakAcceleration();
    const double rounding_s = 8.0 * std::numeric_limits<double>::epsilon() * profile.duration_s();
    const double away_s = 1e-6 * shortest_s;
    const double between_s = (2.0 * away_s + rounding_s) * (1.0 + 1e-9);
    for (const double corner_s : cornersOf(profile)) {
        const TravelPoint before = profile.at(corner_s - away_s);
        const TravelPoint behind = profile.at(corner_s + away_s);
        const double speed = std::fabs(profile.peakSpeed());
        const double acceleration = std::fabs(profile.peakAcceleration());
        ASSERT_NEAR(behind.value, before.value, speed * between_s + 1e-12 * std::fabs(move.distance))
            << corner_s;
        ASSERT_NEAR(behind.speed, before.speed, acceleration * between_s + 1e-12 * speed) << corner_s;
        if (profile.jerk()) {
            ASSERT_NEAR(behind.acceleration, before.acceleration,
                        std::fabs(*profile.jerk()) * between_s + 1e-12 * acceleration)
                << corner_s;
        }
    }
}

// It ends at rest in the distance to the last bit, and both halves meet in the middle.
inline void expectArrival(const TravelProfile& profile, const RandomMove& move) {
    const double end_s = profile.duration_s();
    const TravelPoint end = profile.at(end_s);
    ASSERT_EQ(end.value, move.distance);
    ASSERT_EQ(end.speed, 0.0);
    ASSERT_EQ(end.acceleration, 0.0);
    ASSERT_EQ(profile.at(0.0).value, 0.0);
    ASSERT_NEAR(profile.at(0.5 * end_s).value, 0.5 * move.distance, 1e-8 * std::fabs(move.distance));
}

/// So many random moves: limits kept, no jumps, end met. Every shape has its share of them: constant speed,
/// constant acceleration at most, jerks only, no jerk limit.
inline void expectTravels(std::uint64_t seed, int count) {
    Random random(seed);
    std::array<int, 4> seen{};
    for (int i = 0; i < count && !::testing::Test::HasFatalFailure(); ++i) {
        const RandomMove move = randomMove(random);
        const auto profile = TravelProfile::solve(move.distance, move.limits);
        ASSERT_TRUE(profile) << profile.error().message;
        SCOPED_TRACE(i);
        expectLimitsKept(*profile, move);
        expectContinuous(*profile, move);
        expectArrival(*profile, move);
        // As fast as possible: one of the limits is reached in the middle of the travel.
        constexpr double Near = 1.0 - 1e-9;
        const bool isFast = std::fabs(profile->peakSpeed()) > move.limits.speed * Near;
        const bool isStrong = std::fabs(profile->peakAcceleration()) > move.limits.acceleration * Near;
        const bool isJerky = move.limits.jerk && std::fabs(*profile->jerk()) > *move.limits.jerk * Near;
        ASSERT_TRUE(isJerky || (!move.limits.jerk && isStrong));
        ++seen[!move.limits.jerk ? 3U : isFast ? 0U : isStrong ? 1U : 2U];
    }
    for (const int each : seen) {
        EXPECT_GT(each, count / 40);
    }
}

} // namespace halbench::control
