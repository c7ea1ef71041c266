#pragma once

#include "control/base/result.h"

#include <optional>

namespace halbench::control {

/// Largest speed, acceleration and jerk of a travel, in the unit of the position per s, s^2 and s^3. Without
/// a jerk the acceleration may jump, and the speed is a trapezoid.
struct TravelLimits {
    double speed = 0.0;
    double acceleration = 0.0;
    std::optional<double> jerk;
};

/// The reference at one instant.
struct TravelPoint {
    double value = 0.0;
    double speed = 0.0;
    double acceleration = 0.0;
};

/// Travel from rest to rest over a distance, as fast as the limits allow: the jerk is +j, 0 or -j in seven
/// pieces, of which the constant acceleration and the constant speed drop out where the distance is short.
/// With the durations T_j of one jerk, T_a of the constant acceleration and T_v of the constant speed
///
///   distance = a (T_j + T_a) (2 T_j + T_a + T_v),   a = j T_j,   duration = 4 T_j + 2 T_a + T_v
///
/// (resources/help/planar-theory.md section 9). The end is met exactly; the limits are kept but for rounding,
/// some 1e-15 of them.
class TravelProfile {
public:
    /// Errors: OutOfRange (a limit is not positive, a distance of zero), NotFinite.
    static Result<TravelProfile> solve(double distance, const TravelLimits& limits);

    /// At rest in 0 before the start, at rest in the distance behind the end.
    TravelPoint at(double time_s) const;
    double duration_s() const { return 4.0 * m_jerk_s + 2.0 * m_hold_s + m_flat_s; }
    /// Until the speed is constant, or half of the travel where it never is.
    double ramp_s() const { return 2.0 * m_jerk_s + m_hold_s; }

    double peakSpeed() const { return m_acceleration * (m_jerk_s + m_hold_s); } ///< signed, as the next two
    double peakAcceleration() const { return m_acceleration; }
    std::optional<double> jerk() const; ///< nothing where it has no limit

private:
    TravelProfile() = default;
    void solveLong(double length, const TravelLimits& limits);
    void solveShort(double length, const TravelLimits& limits);
    TravelPoint rising(double time_s) const;

    double m_distance = 0.0;
    double m_acceleration = 0.0;
    double m_jerk_s = 0.0;
    double m_hold_s = 0.0;
    double m_flat_s = 0.0;
};

} // namespace halbench::control
