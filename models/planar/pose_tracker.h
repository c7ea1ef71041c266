#pragma once

#include "models/planar/pose_estimator.h"

#include <Eigen/Core>

namespace halbench::models {

/// Settings of the tracking filter. Process noise per axis: x and y, then rotation.
struct PoseTrackerConfig {
    double period_s = 1e-3;
    double acceleration_m_s2 = 0.05; ///< white, rms per sample
    double acceleration_rad_s2 = 1.0;
    double disturbance_m_s2_per_rts = 3.0; ///< random walk of the disturbance, per square root of a second
    double disturbance_rad_s2_per_rts = 60.0;
};

/// Pose, velocity and disturbance acceleration, (x, y, angle) each, and their covariance.
struct PoseTrackerState {
    Eigen::Matrix<double, 9, 1> mean = Eigen::Matrix<double, 9, 1>::Zero();
    Eigen::Matrix<double, 9, 9> covariance = Eigen::Matrix<double, 9, 9>::Zero();

    PlanarPose pose() const { return {mean(0), mean(1), mean(2)}; }
    PlanarVelocity velocity() const { return {mean(3), mean(4), mean(5)}; }
};

/// What one update told: innovation^T S^-1 innovation, chi-square of the readings in use when all is well.
struct PoseInnovation {
    double chiSquare = 0.0;
    int freedom = 0;
};

/// A tracker at rest at this pose, with the covariance of an estimate and wide velocity and disturbance.
PoseTrackerState startTracker(const PoseTrackerConfig& config, const PoseEstimate& estimate);

/// One period under the known acceleration u = wrench/inertia of that period:
///   q' = q + T v + (T^2/2)(u + d),  v' = v + T (u + d),  d' = d.
void predict(const PoseTrackerConfig& config, PoseTrackerState& state, const Eigen::Vector3d& acceleration);

/// Extended Kalman update with the corrected fields of the chips in use; Joseph's form keeps the covariance
/// positive. Source: resources/help/planar-theory.md section 7.
PoseInnovation update(const PoseSensing& sensing, PoseTrackerState& state, const ChipFields_T& field_T,
                      const ChipMask& used = AllChips);

} // namespace halbench::models
