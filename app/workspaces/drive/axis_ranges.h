#pragma once

#include "control/base/units.h"
#include "devices/axis_spec.h"

namespace halbench::app {

/// Ranges, steps and first values of the fields are given for a rotor, in degrees. On another axis a degree
/// stands for this much, in SI: 0.1 mm along a line, a hundredth of a degree where the travel is bounded.
inline double perDegree(const devices::AxisSpec& axis) {
    constexpr double LinePerDegree_m = 1e-4;
    constexpr double BoundedShare_ratio = 0.01;
    if (axis.positionUnit == "m") {
        return LinePerDegree_m;
    }
    return degreesToRadians(axis.turnsForever ? 1.0 : BoundedShare_ratio);
}

} // namespace halbench::app
