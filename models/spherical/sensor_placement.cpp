#include "models/spherical/sensor_placement.h"

#include "control/base/units.h"
#include "models/spherical/orientation.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <cmath>

namespace halbench::models {
namespace {

PlacementAngles placed_deg(double alpha, double beta, double gamma) {
    return {degreesToRadians(alpha), degreesToRadians(beta), degreesToRadians(gamma)};
}

constexpr double LeastDistance_m = 1e-4;
constexpr double LeastVolume = 1e-3; ///< of the parallelepiped of the axes: 1 when they are orthogonal

} // namespace

Eigen::Matrix3d placementRotation(const PlacementAngles& placement, SensorFrames frames) {
    const Eigen::Matrix3d x = rotationX(placement.alpha_rad);
    const Eigen::Matrix3d y = rotationY(placement.beta_rad);
    const Eigen::Matrix3d z = rotationZ(placement.gamma_rad);
    if (frames == SensorFrames::Zyx) {
        return z * y * x;
    }
    if (frames == SensorFrames::Xyz) {
        return x * y * z;
    }
    // Rz(dg) Ry(db) puts the sensor at theta = 90 deg + db, phi = dg; beyond +-90 degrees of db it has passed
    // the pole and the spherical angles differ.
    const Eigen::Vector3d n = (z * y).col(0);
    const double phi_rad = std::atan2(n.y(), n.x());
    const double theta_rad = std::atan2(std::hypot(n.x(), n.y()), n.z());
    return rotationZ(phi_rad) * rotationY(theta_rad - 0.5 * Pi);
}

SensorPose sensorPose(const Eigen::Matrix3d& rotation, double radius_m) {
    SensorPose pose;
    pose.position_m = radius_m * rotation.col(0);
    pose.axes << rotation.col(0), -rotation.col(2), rotation.col(1);
    return pose;
}

SensorPoses sensorPoses(const SensorTriple& placement, SensorFrames frames, double radius_m) {
    SensorPoses poses;
    for (std::size_t i = 0; i < poses.size(); ++i) {
        poses[i] = sensorPose(placementRotation(placement[i], frames), radius_m);
    }
    return poses;
}

SensorTriple publishedPlacement() {
    return {PlacementAngles{}, placed_deg(0, 0, 45), placed_deg(45, 45, -90)};
}

SensorTriple recommendedPlacement() {
    return {PlacementAngles{}, placed_deg(40, -25, -55), placed_deg(40, 25, 55)};
}

SensorPose displacedPose(const SensorPose& pose, const Eigen::Vector3d& turn_rad,
                         const Eigen::Vector3d& shift_m) {
    return {pose.position_m + shift_m, rotationOfVector(turn_rad) * pose.axes};
}

Result<void> checkSensorPoses(const SensorPoses& poses, double rotorRadius_m) {
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const SensorPose& pose = poses[i];
        if (!pose.position_m.allFinite() || !pose.axes.allFinite()) {
            return failure(ErrorCode::NotFinite, "The pose of a field sensor is not a finite number.");
        }
        if (pose.position_m.norm() <= rotorRadius_m) {
            return failure(
                ErrorCode::OutOfRange,
                fmt::format(
                    "Sensor {} lies inside the rotor: {:.4g} mm from its centre, the rotor has {:.4g} mm.", i,
                    1e3 * pose.position_m.norm(), 1e3 * rotorRadius_m),
                "Place it outside the rotor's outer radius.");
        }
        const bool hasUnitAxes = (pose.axes.colwise().norm().array() - 1.0).abs().maxCoeff() < 1e-6;
        if (!hasUnitAxes || std::abs(pose.axes.determinant()) < LeastVolume) {
            return failure(ErrorCode::OutOfRange,
                           "The three axes of a field sensor must be unit vectors that span the space.");
        }
        for (std::size_t other = 0; other < i; ++other) {
            if ((pose.position_m - poses[other].position_m).norm() < LeastDistance_m) {
                return failure(ErrorCode::OutOfRange,
                               fmt::format("Sensors {} and {} lie at the same place.", other, i),
                               "Each of the three sensors needs a place of its own.");
            }
        }
    }
    return {};
}

} // namespace halbench::models
