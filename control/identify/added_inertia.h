#pragma once

#include "control/identify/joint_estimate.h"

#include <Eigen/Core>

namespace halbench::control {

/// c/J, K_f/J and phi/J of one mounting with their joint covariance.
struct MountingRatios {
    Eigen::Vector3d values = Eigen::Vector3d::Zero();
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// All four constants of the bare motor from a second run with a known inertia fixed to the rotor:
/// every ratio falls by J/(J + added), so that J = added r2/(r1 - r2). The torque constant decides; damping
/// joins in when it tells the same J, because friction may change with the mounting.
struct AddedInertiaEstimate {
    Eigen::Vector4d values = Eigen::Vector4d::Zero(); ///< J, c, K_f, phi of the bare motor
    Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
    bool usesDamping = false;
    double disagreement = 0.0; ///< of the J from damping, in standard errors
};

/// Errors: OutOfRange (added not positive), Refused (the added inertia does not show above its error; hint
/// names how large it should be).
Result<AddedInertiaEstimate> inertiaFromAdded(const MountingRatios& bare, const MountingRatios& loaded,
                                              double added_kg_m2);

} // namespace halbench::control
