#pragma once

#include "models/htm/htm_rotor.h"

namespace halbench::models {

/// Response of a rotor with viscous friction to speed and acceleration after t, for x = c t/J.
struct RotorLag {
    double mean = 1.0;  ///< (1 - e^-x)/x: mean speed over t, of a unit of speed at its start
    double ramp = 0.5;  ///< (x - 1 + e^-x)/x^2: travel over t^2, of a unit of acceleration
    double decay = 1.0; ///< e^-x: what is left of a unit of speed
};

/// Motion of one rotor through steps of one length, as stepRotor() describes it. What depends on the length
/// alone is computed once: for loops over many steps. J > 0, the length not negative.
class RotorStep {
public:
    RotorStep(const RotorConfig& config, double duration_s);
    double duration_s() const { return m_duration_s; }
    void move(RotorState& state, double torque_Nm) const;
    /// The same, and where the energy went.
    RotorEnergy moveCounted(RotorState& state, double torque_Nm) const;

private:
    /// From event to event: each stretch of constant acceleration is told to `onStretch` before the rotor
    /// moves.
    template <typename OnStretch>
    void follow(RotorState& state, double torque_Nm, OnStretch onStretch) const;

    RotorConfig m_config;
    double m_duration_s;
    RotorLag m_whole;
};

} // namespace halbench::models
