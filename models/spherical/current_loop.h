#pragma once

#include "control/base/result.h"

#include <Eigen/Core>

namespace halbench::models {

/// A circular coil of a spherical stator, thin against its radius.
struct CurrentLoop {
    Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
    Eigen::Vector3d axis = Eigen::Vector3d::UnitX(); ///< unit vector; positive current turns about it
    double radius_m = 0.01;
    double turns = 200.0;
};

/// OutOfRange or NotFinite: no positive radius, turns of zero or less, an axis that is no unit vector.
Result<void> checkCurrentLoop(const CurrentLoop& loop);

/// Field for 1 A, T/A, at any point off the wire, by complete elliptic integrals (Smythe, Static and Dynamic
/// Electricity, 3rd ed., 7.10):
///   B_z   = mu0 N/(2 pi Q) [K + (a^2 - rho^2 - z^2)/((a - rho)^2 + z^2) E],   Q^2 = (a + rho)^2 + z^2
///   B_rho = mu0 N z/(2 pi rho Q) [-K + (a^2 + rho^2 + z^2)/((a - rho)^2 + z^2) E],   modulus^2 = 4 a
///   rho/Q^2.
/// On the axis: mu0 N a^2 / (2 (a^2 + z^2)^(3/2)).
Eigen::Vector3d loopField_T_per_A(const CurrentLoop& loop, const Eigen::Vector3d& point_m);

} // namespace halbench::models
