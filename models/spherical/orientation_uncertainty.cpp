#include "models/spherical/orientation_uncertainty.h"

#include "control/base/units.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace halbench::models {
namespace {

constexpr double Normal95 = 1.959963984540054; ///< two-sided quantile
constexpr double SingularCosine = 1e-6;

/// Probability that a planar Gaussian vector with these variances is longer than `radius`, by the trapezoidal
/// rule, which converges exponentially for a periodic integrand.
double tailBeyond(double radius, double larger, double smaller) {
    constexpr int Points = 64;
    double sum = 0.0;
    for (int i = 0; i < Points; ++i) {
        const double c = std::cos(Pi * i / Points);
        const double variance = larger * c * c + smaller * (1.0 - c * c);
        sum += variance > 0.0 ? std::exp(-0.5 * radius * radius / variance) : 0.0;
    }
    return sum / Points;
}

} // namespace

AngleIntervals angleIntervals95(const OrientationAngles& angles, const Eigen::Matrix3d& covariance_rad2) {
    if (std::abs(std::cos(angles.beta_rad)) < SingularCosine) {
        return {Pi, Pi, Pi};
    }
    const Eigen::Matrix3d inverse = rateMatrix(angles).inverse();
    const Eigen::Vector3d variance =
        (inverse * covariance_rad2 * inverse.transpose()).diagonal().cwiseMax(0.0);
    const Eigen::Vector3d half = (Normal95 * variance.cwiseSqrt()).cwiseMin(Pi);
    return {half[0], half[1], half[2]};
}

double shaftCone95_rad(const Eigen::Matrix3d& rotation, const Eigen::Matrix3d& covariance_rad2) {
    const Eigen::Matrix<double, 3, 2> across = rotation.leftCols<2>();
    const Eigen::Matrix2d cut = across.transpose() * covariance_rad2 * across;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(cut, Eigen::EigenvaluesOnly);
    const double smaller = std::max(0.0, eigen.eigenvalues()[0]);
    const double larger = std::max(0.0, eigen.eigenvalues()[1]);
    // One variance alone gives 1.96 sigma, two equal ones 2.4478.
    double low = 1.95 * std::sqrt(larger);
    double high = 2.45 * std::sqrt(larger);
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (low + high);
        (tailBeyond(middle, larger, smaller) > 0.05 ? low : high) = middle;
    }
    return std::min(Pi, high);
}

double rotationDeviation_rad(const Eigen::Matrix3d& covariance_rad2) {
    return std::sqrt(covariance_rad2.trace());
}

} // namespace halbench::models
