#pragma once

#include <Eigen/Core>

namespace halbench::models {

/// Pose of the platen frame C in the lattice frame: a point r' of the platen lies at (x, y) + R(angle) r'.
/// The angle is positive counter-clockwise seen from above; no coordinate wraps around.
/// Source: resources/help/planar-theory.md section 2.
struct PlanarPose {
    double x_m = 0.0;
    double y_m = 0.0;
    double angle_rad = 0.0;
};

struct PlanarVelocity {
    double x_m_s = 0.0;
    double y_m_s = 0.0;
    double angle_rad_s = 0.0;
};

/// Force in lattice axes and torque about the vertical through the origin of the platen frame.
struct PlanarWrench {
    double forceX_N = 0.0;
    double forceY_N = 0.0;
    double torque_Nm = 0.0;
};

/// Number of coils, of Hall chips and of field components that the chips read.
constexpr int CoilCount = 6;
constexpr int ChipCount = 3;
constexpr int FieldCount = 2 * ChipCount;

using CoilCurrents_A = Eigen::Matrix<double, CoilCount, 1>;

inline Eigen::Vector3d vectorOf(const PlanarWrench& wrench) {
    return {wrench.forceX_N, wrench.forceY_N, wrench.torque_Nm};
}
inline PlanarWrench wrenchOf(const Eigen::Vector3d& vector) {
    return {vector.x(), vector.y(), vector.z()};
}

} // namespace halbench::models
