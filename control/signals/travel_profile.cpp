#include "control/signals/travel_profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

Result<void> checkLimit(const char* name, double limit) {
    if (!std::isfinite(limit)) {
        return failure(ErrorCode::NotFinite, fmt::format("the largest {} of a travel is not a number", name),
                       "Give a finite limit.");
    }
    return limit > 0.0
               ? Result<void>()
               : failure(ErrorCode::OutOfRange, fmt::format("the largest {} of a travel is {}", name, limit),
                         "Give a limit above zero.");
}

Result<void> checkTravel(double distance, const TravelLimits& limits) {
    if (!std::isfinite(distance)) {
        return failure(ErrorCode::NotFinite, "the distance of a travel is not a number",
                       "Give a finite distance.");
    }
    if (distance == 0.0) {
        return failure(ErrorCode::OutOfRange, "the distance of a travel is zero", "Give a distance.");
    }
    if (auto speed = checkLimit("speed", limits.speed); !speed) {
        return speed;
    }
    if (auto acceleration = checkLimit("acceleration", limits.acceleration); !acceleration) {
        return acceleration;
    }
    return limits.jerk ? checkLimit("jerk", *limits.jerk) : Result<void>();
}

} // namespace

// Up to the speed, and at that speed for what is left of the length; m_flat_s < 0: it is too short for it.
void TravelProfile::solveLong(double length, const TravelLimits& limits) {
    const double jerk_s = limits.jerk ? limits.acceleration / *limits.jerk : 0.0;
    const double rise_s = limits.speed / limits.acceleration;
    const bool reachesAcceleration = rise_s >= jerk_s;
    m_jerk_s = reachesAcceleration ? jerk_s : std::sqrt(limits.speed / *limits.jerk);
    m_hold_s = reachesAcceleration ? rise_s - jerk_s : 0.0;
    m_flat_s = length / limits.speed - 2.0 * m_jerk_s - m_hold_s;
}

// length = a x (x + T_j) with x = T_j + T_a, or 2 j T_j^3 where the acceleration is not reached either.
void TravelProfile::solveShort(double length, const TravelLimits& limits) {
    const double jerk_s = limits.jerk ? limits.acceleration / *limits.jerk : 0.0;
    m_flat_s = 0.0;
    if (length >= 2.0 * limits.acceleration * jerk_s * jerk_s) {
        m_jerk_s = jerk_s;
        const double root_s = std::sqrt(jerk_s * jerk_s + 4.0 * length / limits.acceleration);
        m_hold_s = std::max(0.0, 0.5 * (root_s - 3.0 * jerk_s));
    } else {
        m_jerk_s = std::cbrt(0.5 * length / *limits.jerk);
        m_hold_s = 0.0;
    }
}

Result<TravelProfile> TravelProfile::solve(double distance, const TravelLimits& limits) {
    if (auto checked = checkTravel(distance, limits); !checked) {
        return failure(checked.error());
    }
    TravelProfile profile;
    profile.solveLong(std::fabs(distance), limits);
    if (profile.m_flat_s < 0.0) {
        profile.solveShort(std::fabs(distance), limits);
    }
    profile.m_distance = distance;
    const double rise_s = profile.m_jerk_s + profile.m_hold_s;
    profile.m_acceleration = distance / (rise_s * (rise_s + profile.m_jerk_s + profile.m_flat_s));
    return profile;
}

std::optional<double> TravelProfile::jerk() const {
    return m_jerk_s > 0.0 ? std::optional(m_acceleration / m_jerk_s) : std::nullopt;
}

TravelPoint TravelProfile::rising(double time_s) const {
    const double peak = peakSpeed();
    if (time_s < m_jerk_s) {
        const double acceleration = m_acceleration * (time_s / m_jerk_s);
        return {acceleration * time_s * time_s / 6.0, 0.5 * acceleration * time_s, acceleration};
    }
    if (time_s < m_jerk_s + m_hold_s) {
        const double held_s = time_s - m_jerk_s;
        return {m_acceleration * (m_jerk_s * m_jerk_s / 6.0 + 0.5 * held_s * (m_jerk_s + held_s)),
                m_acceleration * (0.5 * m_jerk_s + held_s), m_acceleration};
    }
    if (time_s < ramp_s()) {
        const double left_s = ramp_s() - time_s;
        const double acceleration = m_acceleration * (left_s / m_jerk_s);
        return {0.5 * peak * ramp_s() - peak * left_s + acceleration * left_s * left_s / 6.0,
                peak - 0.5 * acceleration * left_s, acceleration};
    }
    return {peak * (time_s - 0.5 * ramp_s()), peak, 0.0};
}

TravelPoint TravelProfile::at(double time_s) const {
    const double left_s = duration_s() - time_s;
    if (time_s < 0.0) {
        return {};
    }
    if (left_s <= 0.0) {
        return {m_distance, 0.0, 0.0};
    }
    if (left_s < ramp_s()) { // the way there, backwards
        const TravelPoint mirrored = rising(left_s);
        return {m_distance - mirrored.value, mirrored.speed, -mirrored.acceleration};
    }
    return rising(time_s);
}

} // namespace halbench::control
