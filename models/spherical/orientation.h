#pragma once

#include <Eigen/Core>
#include <array>

namespace halbench::models {

/// Orientation of the spherical rotor: rotation matrix M from rotor frame (d, q, p; p is the shaft) to stator
/// frame (X, Y, Z), active, about fixed stator axes in the order Z, then Y, then X:
///   M = Rx(alpha) Ry(beta) Rz(gamma).
/// Euler singularity only at beta = +-90 degrees. Source: resources/help/spherical-theory.md section 2.
struct OrientationAngles {
    double alpha_rad = 0.0;
    double beta_rad = 0.0;
    double gamma_rad = 0.0;
};

/// Direction of the shaft: Theta from +Z, Phi from +X towards +Y in [0, 2 pi).
struct ShaftDirection {
    double theta_rad = 0.0;
    double phi_rad = 0.0;
};

Eigen::Matrix3d rotationX(double angle_rad);
Eigen::Matrix3d rotationY(double angle_rad);
Eigen::Matrix3d rotationZ(double angle_rad);

Eigen::Matrix3d rotationOf(const OrientationAngles& angles);
/// alpha, gamma in (-pi, pi], beta in [-pi/2, pi/2].
OrientationAngles anglesOf(const Eigen::Matrix3d& rotation);

ShaftDirection shaftOf(const Eigen::Matrix3d& rotation);
/// The angles whose shaft points there with the spin gamma.
OrientationAngles anglesForShaft(const ShaftDirection& shaft, double gamma_rad);

/// [w]x with [w]x v = w x v.
Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& vector);
/// exp([w]x): rotation by |w| about w.
Eigen::Matrix3d rotationOfVector(const Eigen::Vector3d& vector_rad);
/// The rotation vector w, |w| <= pi, with exp([w]x) = rotation.
Eigen::Vector3d vectorOfRotation(const Eigen::Matrix3d& rotation);

/// Columns a with w = a (alpha', beta', gamma'): angular rate in the stator frame.
Eigen::Matrix3d rateMatrix(const OrientationAngles& angles);

/// The rotor's field is the same for M, M Rx(pi), M Ry(pi), M Rz(pi): these four rotations.
const std::array<Eigen::Vector3d, 4>& symmetrySigns();

/// Of the four equal fields the one with the shaft up (M33 >= 0) and gamma in [-90, 90] degrees (M11 >= 0).
Eigen::Matrix3d representative(const Eigen::Matrix3d& rotation);

/// Smallest rotation angle between an orientation and the four symmetric images of another, rad.
double symmetricError_rad(const Eigen::Matrix3d& rotation, const Eigen::Matrix3d& reference);
/// The image of `rotation` that lies nearest to `reference`.
Eigen::Matrix3d nearestImage(const Eigen::Matrix3d& rotation, const Eigen::Matrix3d& reference);

} // namespace halbench::models
