#pragma once

#include <Eigen/Core>

namespace halbench::models {

/// A cuboid magnet, uniformly magnetised along its own +x; turned about z together with its magnetisation.
struct CuboidMagnet {
    Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
    Eigen::Vector3d halfSize_m = Eigen::Vector3d::Zero();
    double angle_rad = 0.0;
    double remanence_T = 0.0;
};

/// Flux density of a cuboid with half-sizes (a, b, c) in its own frame, for 1 T of remanence along +x:
///   B_x =  1/(4 pi) sum sigma atan2(Y Z, X R)
///   B_y = -1/(4 pi) sum sigma atanh(Z / R)
///   B_z = -1/(4 pi) sum sigma atanh(Y / R),  X = x -+ a, Y = y -+ b, Z = z -+ c, R = |(X, Y, Z)|
/// summed over the eight corners, sigma = product of the corner signs. atanh keeps its digits near the edge
/// lines where ln(R + Z) loses all of them. Valid outside the magnet, not on its edge lines. Source:
/// resources/help/htm-theory.md section 4.2.
Eigen::Vector3d cuboidField(const Eigen::Vector3d& halfSize_m, const Eigen::Vector3d& point_m);

/// Tesla, in the frame the magnet is placed in.
Eigen::Vector3d magnetField_T(const CuboidMagnet& magnet, const Eigen::Vector3d& point_m);

/// The field of the same point dipole, moment m = B_r V / mu0: what a distant cuboid looks like.
Eigen::Vector3d dipoleField_T(const CuboidMagnet& magnet, const Eigen::Vector3d& point_m);

/// The cross-section alone, infinitely long along z; the z half-size is not used.
Eigen::Vector2d longBarField_T(const CuboidMagnet& magnet, const Eigen::Vector2d& point_m);

/// Strongest remanence of magnets one can buy is about 1.48 T; a value above this limit is flagged, never
/// used silently. Source: resources/help/htm-theory.md sections 4.3 and 6.11.
constexpr double LargestRealRemanence_T = 1.5;
constexpr bool isRemanenceReal(double remanence_T) {
    return remanence_T <= LargestRealRemanence_T;
}

} // namespace halbench::models
