#include "models/spherical/additive_inverse.h"

#include "control/base/units.h"
#include "models/spherical/rotation_fit.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace halbench::models {
namespace {

constexpr int MaxIterations = 60;
constexpr double LastStep_rad = 1e-10;

OrientationAngles moved(const OrientationAngles& angles, const Eigen::Vector3d& step_rad) {
    return {angles.alpha_rad + step_rad[0], angles.beta_rad + step_rad[1], angles.gamma_rad + step_rad[2]};
}

} // namespace

OrientationAngles additiveInverse(double strength_T, const SphericalReadings& readings_T) {
    const double gamma_rad = 0.5 * std::atan2(readings_T[3], readings_T[0]);
    const double c = std::cos(2.0 * gamma_rad);
    const double s = std::sin(2.0 * gamma_rad);
    const Eigen::Vector2d main_T = readings_T.segment<2>(1);
    const Eigen::Vector2d other_T = readings_T.segment<2>(4);
    const Eigen::Vector2d tilted_T = c * main_T + s * other_T;
    const Eigen::Vector2d across_T = c * other_T - s * main_T;
    const double alpha_rad = std::atan2(-across_T[0], across_T[1]);
    const double cosine = across_T.norm() / (2.0 * strength_T);
    const double doubleSine =
        -(tilted_T[0] * std::cos(alpha_rad) + tilted_T[1] * std::sin(alpha_rad)) / strength_T;
    return {alpha_rad, std::atan2(doubleSine / (2.0 * cosine), cosine), gamma_rad};
}

std::array<OrientationAngles, 2> sameMainReadings(const OrientationAngles& angles) {
    const double chi_rad = std::atan2(-2.0 * std::sin(2.0 * angles.gamma_rad) * std::cos(angles.beta_rad),
                                      -std::cos(2.0 * angles.gamma_rad) * std::sin(2.0 * angles.beta_rad));
    const double turned_rad = angles.alpha_rad + 2.0 * chi_rad;
    return {OrientationAngles{std::remainder(turned_rad, 2.0 * Pi), angles.beta_rad, -angles.gamma_rad},
            OrientationAngles{std::remainder(turned_rad - Pi, 2.0 * Pi), -angles.beta_rad, angles.gamma_rad}};
}

AdditiveFit fitAdditiveModel(const AdditiveModel& model, const SphericalReadings& readings_T,
                             const OrientationAngles& start) {
    AdditiveFit fit;
    fit.angles = start;
    OrientationJacobian jacobian;
    SphericalReadings residual_T = readings_T - additiveReadingsAndJacobian(model, start, jacobian);
    fit.squares_T2 = residual_T.squaredNorm();
    double damping = 1e-3;
    while (fit.iterations < MaxIterations && !fit.hasConverged && damping < 1e12) {
        ++fit.iterations;
        Eigen::Matrix3d normal = jacobian.transpose() * jacobian;
        // The mean as well: at beta = gamma = 0 a diagonal entry is small.
        normal.diagonal().array() += damping * normal.diagonal().mean();
        const Eigen::Vector3d step = normal.ldlt().solve(jacobian.transpose() * residual_T);
        const OrientationAngles next = moved(fit.angles, step);
        OrientationJacobian nextJacobian;
        const SphericalReadings nextResidual_T =
            readings_T - additiveReadingsAndJacobian(model, next, nextJacobian);
        const bool isLast = step.norm() < LastStep_rad;
        if (isLast || nextResidual_T.squaredNorm() <= fit.squares_T2) {
            fit.angles = next;
            fit.hasConverged = isLast;
            fit.squares_T2 = nextResidual_T.squaredNorm();
            residual_T = nextResidual_T;
            jacobian = nextJacobian;
            damping = std::fmax(0.1 * damping, 1e-15);
        } else {
            damping *= 10.0;
        }
    }
    fit.angles.gamma_rad = std::remainder(fit.angles.gamma_rad, Pi);
    return fit;
}

AdditiveFit searchAdditiveModel(const AdditiveModel& model, const SphericalReadings& readings_T) {
    AdditiveFit best = fitAdditiveModel(model, readings_T, additiveInverse(model.strength_T, readings_T));
    for (int i = 0; i < FallbackStarts; ++i) {
        const AdditiveFit fit = fitAdditiveModel(model, readings_T, anglesOf(fallbackStart(i)));
        best = fit.squares_T2 < best.squares_T2 ? fit : best;
    }
    return best;
}

} // namespace halbench::models
