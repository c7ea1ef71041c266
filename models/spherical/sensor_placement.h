#pragma once

#include "control/base/result.h"

#include <Eigen/Core>
#include <array>
#include <string_view>

namespace halbench::models {

/// Nine readings in tesla: (R, Theta, Phi) of sensor 0, then 1, then 2.
using SphericalReadings = Eigen::Matrix<double, 9, 1>;

/// Rotation (da, db, dg) that takes the main sensor, which sits on +X, to its place.
struct PlacementAngles {
    double alpha_rad = 0.0;
    double beta_rad = 0.0;
    double gamma_rad = 0.0;
};
using SensorTriple = std::array<PlacementAngles, 3>;

/// How the placement angles become the sensor's rotation S. For the published placement all three put the
/// sensors at the same places; they differ by a roll about the radius.
enum class SensorFrames {
    Zyx,     ///< S = Rz(dg) Ry(db) Rx(da): about stator X, then Y, then Z
    Xyz,     ///< S = Rx(da) Ry(db) Rz(dg)
    Natural, ///< S = Rz(phi) Ry(theta - 90 deg): the place of Zyx without any roll
};
inline constexpr std::array<std::string_view, 3> SensorFrameNames = {"zyx", "xyz", "nat"};

/// A three-axis field sensor on the stator.
struct SensorPose {
    Eigen::Vector3d position_m = Eigen::Vector3d(0.05, 0.0, 0.0);
    /// Unit vectors of its axes (e_R, e_Theta, e_Phi) as columns, stator frame. Measured axes need not be
    /// exactly radial or orthogonal.
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
};
using SensorPoses = std::array<SensorPose, 3>;

/// S: the main sensor's frame turned to the placement.
Eigen::Matrix3d placementRotation(const PlacementAngles& placement, SensorFrames frames);

/// p = r S e_x, e_R = S e_x, e_Theta = -S e_z, e_Phi = S e_y.
SensorPose sensorPose(const Eigen::Matrix3d& rotation, double radius_m);
SensorPoses sensorPoses(const SensorTriple& placement, SensorFrames frames, double radius_m);

/// Main (0,0,0), auxiliary (0,0,45) and (45,45,-90) degrees: the published placement.
SensorTriple publishedPlacement();
/// Main (0,0,0), auxiliary (40,-25,-55) and (40,25,55) degrees: from a search on a 5-degree lattice for
/// the largest worst reading.
SensorTriple recommendedPlacement();

/// The pose turned by a small rotation vector (stator frame) about its own place, and moved.
SensorPose displacedPose(const SensorPose& pose, const Eigen::Vector3d& turn_rad,
                         const Eigen::Vector3d& shift_m);

/// OutOfRange or NotFinite: sensors inside the rotor, two at one place, axes that are no unit vectors or lie
/// in one plane.
Result<void> checkSensorPoses(const SensorPoses& poses, double rotorRadius_m);

} // namespace halbench::models
