#pragma once

#include "control/design/position_loop.h"

namespace halbench::control {

/// (1 - e^-x)/x and (x - 1 + e^-x)/x^2, accurate also where x is small or zero: what a held input does to
/// speed and angle over an interval of x = a t.
double heldSpeedShare(double x);
double heldAngleShare(double x);

struct RotorState {
    double angle_rad = 0.0;
    double speed_rad_s = 0.0;
};

/// Exact motion of psi'' + a psi' = k i (no friction) over a time of constant current.
RotorState advance(const PositionPlant& plant, const RotorState& state, double current_A, double time_s);

} // namespace halbench::control
