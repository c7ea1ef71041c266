#pragma once

#include "control/identify/motion_segments.h"

#include <optional>
#include <span>
#include <vector>

namespace halbench::control {

/// An angle column as it must be for a fit: growing on through each turn.
struct UnwrappedAngle {
    std::vector<double> angle_rad;
    std::optional<double> period_rad; ///< where it wrapped; empty: it did not
    int wraps = 0;
};

/// Undoes the wrap of an angle that starts anew after a turn (or any other fixed span, e.g. a counter). It is
/// a wrap when every jump between neighbouring rows has the same size, within 2 %, once the motion of the
/// rows around it is taken off, and the whole column stays within that span. Anything else is left as it is.
UnwrappedAngle unwrapAngle(std::span<const double> angle_rad);

/// A column that holds the speed instead of the angle settles, under each constant current, at a value that
/// goes with the current; an angle goes on growing while the rotor turns and goes with no current.
bool looksLikeSpeed(std::span<const double> column, std::span<const CurrentPlateau> plateaus);

} // namespace halbench::control
