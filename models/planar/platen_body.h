#pragma once

#include "models/planar/planar_pose.h"

#include <Eigen/Core>

namespace halbench::models {

/// Rigid platen with three degrees of freedom. About the real centre of mass G = C + R r_G:
///   m G'' = F + F_cable + F_stop - c G',   Iz angle'' = T_C - (R r_G) x F + moments of cable and stops - c_a
///   angle'
/// Cable: F = -k (anchor - anchor at the pose zero) + slow force, at the anchor, torque -k_a angle. Stops:
/// one-sided springs with damping at +-travel of each coordinate of C. Source:
/// resources/help/planar-theory.md section 8.
struct PlatenConfig {
    double mass_kg = 0.64;
    double inertia_kg_m2 = 1e-3;
    Eigen::Vector2d massCentre_m = Eigen::Vector2d::Zero(); ///< r_G, platen axes
    double damping_Ns_per_m = 0.1;
    double damping_Nms_per_rad = 1e-4;
    double cableStiffness_N_per_m = 2.0;
    double cableTorsion_Nm_per_rad = 5e-3;
    Eigen::Vector2d anchor_m = Eigen::Vector2d::Zero(); ///< platen axes
    double travel_m = 50e-3;
    double travel_rad = 20e-3;
    double stopStiffness_N_per_m = 2e4;
    double stopStiffness_Nm_per_rad = 200.0;
    double stopDamping_Ns_per_m = 0.0;
    double stopDamping_Nms_per_rad = 0.0;
};

struct PlatenState {
    PlanarPose pose;
    PlanarVelocity velocity; ///< of C
};

/// Pose in the middle of the next step without forces: where the forces of the step are taken.
PlanarPose middlePose(const PlatenConfig& config, const PlatenState& state, double step_s);

/// One step under the coils' wrench (about C, taken at the middle pose): drift, kick, drift, second order and
/// without secular error in energy; damping exact. Steps of 0.5 ms or less: the stops' springs need w h <
/// 0.5.
void stepPlaten(const PlatenConfig& config, PlatenState& state, const PlanarWrench& coils,
                const Eigen::Vector2d& slowForce_N, double step_s);

/// (m/2) |G'|^2 + (Iz/2) angle'^2
double kineticEnergy_J(const PlatenConfig& config, const PlatenState& state);
/// Energy in the springs of cable and stops.
double springEnergy_J(const PlatenConfig& config, const PlatenState& state);

} // namespace halbench::models
