#include "models/spherical/rotation_fit.h"

#include "control/base/units.h"
#include "models/spherical/orientation.h"
#include "models/spherical/tensor_rotation.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>

namespace halbench::models {
namespace {

/// A step may reduce the field's factor to this share.
constexpr double LeastFactor_ratio = 0.3;
constexpr double NearMinimum_rad = 0.01;

/// Normal equations of the unknowns (w, ds) at one point; w in rotor axes.
struct NormalEquations {
    double cost = 0.0;
    Eigen::Matrix4d information;
    Eigen::Vector4d gradient;
};

struct FitModel {
    const RotorField& field;
    const SensorPoses& poses;
    const TensorSystem& system;
    const SphericalReadings& readings_T;

    NormalEquations at(const Eigen::Matrix3d& rotation, double scale) const {
        return field.hasHarmonics() ? withHarmonics(rotation, scale) : ofTensor(rotation, scale);
    }

private:
    NormalEquations ofTensor(const Eigen::Matrix3d& rotation, double scale) const {
        Eigen::Matrix<double, 5, 4> slope;
        slope.leftCols<3>() = (scale * field.config().strength_T) * unitTensorDerivative(rotation);
        slope.col(3) = field.config().strength_T * unitTensor(rotation);
        const SphericalReadings residual_T = readings_T - system.design() * (scale * slope.col(3));
        NormalEquations normal;
        normal.cost = system.chiSquare(residual_T);
        normal.gradient = slope.transpose() * (system.weightedDesign() * residual_T);
        normal.information = slope.transpose() * (system.information() * slope);
        return normal;
    }

    NormalEquations withHarmonics(const Eigen::Matrix3d& rotation, double scale) const {
        OrientationJacobian jacobian;
        Eigen::Matrix<double, 9, 4> slope;
        slope.col(3) = field.readingsAndJacobian(rotation, poses, jacobian);
        slope.leftCols<3>() = scale * jacobian * rotation;
        const SphericalReadings residual_T = readings_T - scale * slope.col(3);
        const Eigen::Matrix<double, 9, 4> weighted = system.weight() * slope;
        NormalEquations normal;
        normal.cost = system.chiSquare(residual_T);
        normal.gradient = weighted.transpose() * residual_T;
        normal.information = slope.transpose() * weighted;
        return normal;
    }
};

void hold(NormalEquations& normal) {
    normal.information.row(3).setZero();
    normal.information.col(3).setZero();
    normal.information(3, 3) = 1.0;
    normal.gradient[3] = 0.0;
}

Eigen::Matrix3d covarianceOf(const NormalEquations& normal, const Eigen::Matrix3d& rotation) {
    const Eigen::FullPivLU<Eigen::Matrix4d> factor(normal.information);
    if (!factor.isInvertible()) {
        return Eigen::Matrix3d::Zero();
    }
    const Eigen::Matrix4d inverse = factor.inverse();
    return rotation * inverse.topLeftCorner<3, 3>() * rotation.transpose();
}

} // namespace

RotationFit fitRotation(const RotorField& field, const SensorPoses& poses, const TensorSystem& system,
                        const SphericalReadings& readings_T, const Eigen::Matrix3d& start,
                        const RotationFitConfig& config) {
    const FitModel model{field, poses, system, readings_T};
    RotationFit fit;
    fit.rotation = start;
    // Too few channels for the tensor do not determine its strength either.
    const bool isStrengthFree = config.isStrengthFree && system.isDetermined();
    double scale = 1.0;
    if (isStrengthFree && !field.hasHarmonics()) {
        scale = strengthOf_T(system.solve(readings_T)) / field.config().strength_T;
    }
    // Only near the minimum: far off, a small factor explains any readings better than a wrong pose does.
    bool isStrengthFitted = false;
    double damping = config.firstDamping_ratio;
    NormalEquations normal = model.at(fit.rotation, scale);
    while (fit.iterations < config.iterations && !fit.hasConverged) {
        ++fit.iterations;
        if (!isStrengthFitted) {
            hold(normal);
        }
        Eigen::Matrix4d damped = normal.information;
        // A part of the mean as well: at a singular pose a diagonal entry may vanish.
        damped.diagonal() *= 1.0 + damping;
        damped.diagonal().head<3>().array() += 0.1 * damping * normal.information.diagonal().head<3>().mean();
        const Eigen::Vector4d step = damped.ldlt().solve(normal.gradient);
        const Eigen::Vector3d turn = step.head<3>();
        const Eigen::Matrix3d turned = fit.rotation * rotationOfVector(turn);
        const double nextScale = scale + step[3];
        const bool isLast = turn.norm() < config.lastStep_rad && isStrengthFitted == isStrengthFree;
        const NormalEquations next = model.at(turned, nextScale);
        // Rounding may lift the cost of a last step.
        // A negative factor is another pose: the field turned by 90 degrees about the shaft.
        const bool keepsSign = nextScale > LeastFactor_ratio * scale;
        if (keepsSign && (isLast || next.cost <= normal.cost)) {
            fit.rotation = turned;
            scale = nextScale;
            normal = next;
            damping = std::fmax(0.1 * damping, 1e-15);
            fit.hasConverged = isLast;
            isStrengthFitted = isStrengthFree && (isStrengthFitted || turn.norm() < NearMinimum_rad);
        } else {
            damping *= 10.0;
            if (damping > 1e12) {
                break;
            }
        }
    }
    if (!isStrengthFree) {
        hold(normal);
    }
    fit.chiSquare = normal.cost;
    fit.strength_T = scale * field.config().strength_T;
    if (fit.hasConverged) {
        fit.covariance_rad2 = covarianceOf(normal, fit.rotation);
    }
    fit.rotation = representative(fit.rotation);
    return fit;
}

Eigen::Matrix3d fallbackStart(int index) {
    const double alpha_deg = (index & 1) != 0 ? 25.0 : -25.0;
    const double beta_deg = (index & 2) != 0 ? 25.0 : -25.0;
    const double gamma_deg = -67.5 + 45.0 * (index >> 2);
    return rotationOf({degreesToRadians(alpha_deg), degreesToRadians(beta_deg), degreesToRadians(gamma_deg)});
}

RotationSearch searchRotation(const RotorField& field, const SensorPoses& poses, const TensorSystem& system,
                              const SphericalReadings& readings_T, const Eigen::Matrix3d& start, double limit,
                              bool checksOthers, const RotationFitConfig& config) {
    const double elsewhere_rad = degreesToRadians(1.0);
    RotationSearch search;
    for (int i = 0; i <= FallbackStarts; ++i) {
        const RotationFit fit =
            fitRotation(field, poses, system, readings_T, i == 0 ? start : fallbackStart(i - 1), config);
        ++search.starts;
        const bool isGood = fit.hasConverged && fit.chiSquare <= limit;
        const bool isElsewhere =
            i > 0 && symmetricError_rad(fit.rotation, search.best.rotation) > elsewhere_rad;
        if (isGood && search.isAccepted && isElsewhere) {
            search.isAmbiguous = true;
            search.other = fit.rotation;
        }
        if (i == 0 || (isGood && !search.isAccepted) ||
            (isGood == search.isAccepted && fit.chiSquare < search.best.chiSquare)) {
            if (search.isAmbiguous && isElsewhere) {
                search.other = search.best.rotation;
            }
            search.best = fit;
        }
        search.isAccepted = search.isAccepted || isGood;
        if (search.isAccepted && !checksOthers) {
            break;
        }
    }
    return search;
}

} // namespace halbench::models
