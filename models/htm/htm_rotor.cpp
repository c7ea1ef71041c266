#include "models/htm/htm_rotor.h"

#include "models/htm/rotor_step.h"

#include <cmath>

namespace halbench::models {
namespace {

double frictionHere_Nm(const RotorConfig& config, const RotorState& state, double direction) {
    const double perTurn =
        config.perTurn_ratio == 0.0
            ? 1.0
            : 1.0 + config.perTurn_ratio * std::sin(state.angle_rad + config.perTurnPhase_rad);
    return config.coulombFriction_Nm * state.friction_ratio * perTurn *
           (1.0 + direction * config.asymmetry_ratio);
}

} // namespace

double kineticFriction_Nm(const RotorConfig& config, const RotorState& state, double direction) {
    const double friction = frictionHere_Nm(config, state, direction);
    if (config.stribeckSpeed_rad_s == 0.0) {
        return friction;
    }
    const double ratio = state.speed_rad_s / config.stribeckSpeed_rad_s;
    return friction * (1.0 + (config.staticFriction_ratio - 1.0) * std::exp(-ratio * ratio));
}

double staticFriction_Nm(const RotorConfig& config, const RotorState& state, double direction) {
    return config.staticFriction_ratio * frictionHere_Nm(config, state, direction);
}

RotorEnergy stepRotor(const RotorConfig& config, RotorState& state, double torque_Nm, double duration_s) {
    return RotorStep(config, duration_s).moveCounted(state, torque_Nm);
}

double kineticEnergy_J(const RotorConfig& config, const RotorState& state) {
    return 0.5 * config.inertia_kg_m2 * state.speed_rad_s * state.speed_rad_s;
}

} // namespace halbench::models
