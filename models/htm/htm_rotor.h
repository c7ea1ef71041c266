#pragma once

namespace halbench::models {

/// Rigid rotor with viscous and Coulomb friction:
///   J psi'' + c psi' + K_f sgn(psi') = tau,   at rest while |tau| <= K_s.
/// Source: resources/help/htm-theory.md section 3.1. J > 0; c and K_f may be zero.
struct RotorConfig {
    double inertia_kg_m2 = 5.5e-4;
    double viscousDamping_Nm_s = 1.23e-3;
    double coulombFriction_Nm = 2.05e-2;
    double staticFriction_ratio = 1.0; ///< K_s / K_f
    double asymmetry_ratio = 0.0; ///< friction of positive motion is (1 + this) K_f, of negative (1 - this)
    double perTurn_ratio = 0.0;   ///< K_f (1 + this sin(psi + phase))
    double perTurnPhase_rad = 0.0;
    double stribeckSpeed_rad_s = 0.0; ///< K_f + (K_s - K_f) exp(-(omega/this)^2); 0: K_f as soon as it moves
};

struct RotorState {
    double angle_rad = 0.0;
    double speed_rad_s = 0.0;
    double friction_ratio = 1.0; ///< this run's friction over K_f: the run-to-run scatter
};

/// Where the energy of one step went; kinetic change = electrical - friction - viscous.
struct RotorEnergy {
    double electricalWork_J = 0.0;
    double frictionLoss_J = 0.0;
    double viscousLoss_J = 0.0;
};

/// Friction torque (positive) that opposes motion in `direction` (+1 or -1) at this angle and speed.
double kineticFriction_Nm(const RotorConfig& config, const RotorState& state, double direction);
/// The torque that a rotor at rest withstands in `direction`.
double staticFriction_Nm(const RotorConfig& config, const RotorState& state, double direction);

/// Moves the rotor through `duration_s` of constant torque. Rest is a state: the solution between events is
/// closed form, the speed is set to exactly zero at its zero crossing and the rest rule decides. Exact for
/// any duration while friction does not depend on angle or speed; with the once-per-turn or Stribeck part
/// friction is frozen at the start of each call, so keep steps at 0.25 ms.
RotorEnergy stepRotor(const RotorConfig& config, RotorState& state, double torque_Nm, double duration_s);

/// (J/2) omega^2
double kineticEnergy_J(const RotorConfig& config, const RotorState& state);

} // namespace halbench::models
