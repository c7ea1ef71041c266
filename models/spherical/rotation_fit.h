#pragma once

#include "models/spherical/tensor_system.h"

namespace halbench::models {

/// Levenberg-Marquardt on SO(3).
struct RotationFitConfig {
    int iterations = 60;
    double firstDamping_ratio = 1e-3;
    double lastStep_rad = 1e-6; ///< converged below; the steps fall quadratically there
    bool isStrengthFree = true; ///< a common factor of the field is fitted too if the tensor is determined
};

struct RotationFit {
    bool hasConverged = false;
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    double strength_T = 0.0; ///< q
    double chiSquare = 0.0;
    /// Of the rotation vector in stator axes, rad^2, when the fit has converged and determines it; else zero.
    Eigen::Matrix3d covariance_rad2 = Eigen::Matrix3d::Zero();
    int iterations = 0;
};

/// Minimum of r^T W' r, r = readings - s f(M), over the rotation M <- exp([w]x) M and the factor s, from the
/// start given. The model f has the field's harmonics; without them it works on the five tensor coordinates.
/// No allocation.
RotationFit fitRotation(const RotorField& field, const SensorPoses& poses, const TensorSystem& system,
                        const SphericalReadings& readings_T, const Eigen::Matrix3d& start,
                        const RotationFitConfig& config = {});

/// The search over all starts: the first one that is accepted, or the best.
struct RotationSearch {
    RotationFit best;
    bool isAccepted = false;
    int starts = 0;
    bool isAmbiguous = false; ///< with `checksOthers`: another pose explains the readings as well
    Eigen::Matrix3d other = Eigen::Matrix3d::Identity(); ///< that pose
};

/// 16 fallback starts spread over the poses that are not images of each other.
constexpr int FallbackStarts = 16;
Eigen::Matrix3d fallbackStart(int index);

/// From `start`, then from the fallback starts until a fit has a chi-square of at most `limit`. With
/// `checksOthers` all starts are used and a second accepted pose farther than 1 degree away is reported.
RotationSearch searchRotation(const RotorField& field, const SensorPoses& poses, const TensorSystem& system,
                              const SphericalReadings& readings_T, const Eigen::Matrix3d& start, double limit,
                              bool checksOthers, const RotationFitConfig& config = {});

} // namespace halbench::models
