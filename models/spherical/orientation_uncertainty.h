#pragma once

#include "models/spherical/orientation.h"

namespace halbench::models {

/// Half-widths of the 95 % intervals of the three angles, rad; pi where the angles are singular (beta = +-90
/// degrees).
struct AngleIntervals {
    double alpha_rad = 0.0;
    double beta_rad = 0.0;
    double gamma_rad = 0.0;
};

/// 1.96 sqrt of the diagonal of A^-1 C A^-T, A = rateMatrix, C covariance of the rotation vector in stator
/// axes (rad^2).
AngleIntervals angleIntervals95(const OrientationAngles& angles, const Eigen::Matrix3d& covariance_rad2);

/// Half-angle of the cone about the shaft that holds its direction with 95 %: r of
///   (1/2 pi) int exp(-r^2/(2 (s1 cos^2 t + s2 sin^2 t))) dt = 0.05,
/// s1, s2 variances of the rotation across the shaft. At most pi.
double shaftCone95_rad(const Eigen::Matrix3d& rotation, const Eigen::Matrix3d& covariance_rad2);

/// sqrt of the trace: rms of the rotation angle.
double rotationDeviation_rad(const Eigen::Matrix3d& covariance_rad2);

} // namespace halbench::models
