#pragma once

#include "control/law/position_loop.h"

namespace halbench::control {

/// (1 - e^-x)/x and (x - 1 + e^-x)/x^2, accurate also where x is small or zero: what a held input does to
/// speed and angle over an interval of x = a t.
double heldSpeedShare(double x);
double heldAngleShare(double x);

struct RotorState {
    double angle_rad = 0.0;
    double speed_rad_s = 0.0;
};

/// What an interval makes of the state, of a rotor that is moved over many of the same length.
struct SampledAxis {
    double decay_ratio = 0.0;   ///< of the speed
    double coast_s = 0.0;       ///< angle per speed
    double drive_rad_s_A = 0.0; ///< speed per current
    double push_rad_A = 0.0;    ///< angle per current

    SampledAxis(const PositionPlant& plant, double interval_s);
    void move(RotorState& state, double current_A) const {
        state.angle_rad += coast_s * state.speed_rad_s + push_rad_A * current_A;
        state.speed_rad_s = decay_ratio * state.speed_rad_s + drive_rad_s_A * current_A;
    }
};

/// Exact motion of psi'' + a psi' = k i (no friction) over a time of constant current.
RotorState advance(const PositionPlant& plant, const RotorState& state, double current_A, double time_s);

} // namespace halbench::control
