#include "models/spherical/rotation_fit.h"

#include "control/base/units.h"
#include "models/spherical/orientation.h"
#include "models/spherical/tensor_rotation.h"

#include <Eigen/LU>
#include <cmath>

namespace halbench::models {
namespace {

/// A step may reduce the field's factor to this share.
constexpr double LeastFactor_ratio = 0.3;
constexpr double NearMinimum_rad = 0.01;

/// Normal equations of the unknowns (w, ds) at one point; w in rotor axes. Symmetric: below the diagonal of
/// w, the last row is not used.
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
    /// Tensor of the readings and the chi-square it leaves, when it is determined and all of the field.
    bool isTensor = false;
    TensorVector tensor_T = TensorVector::Zero();
    double leftOver = 0.0;

    NormalEquations at(const Eigen::Matrix3d& rotation, double scale) const {
        return field.hasHarmonics() ? withHarmonics(rotation, scale) : ofTensor(rotation, scale);
    }

private:
    NormalEquations ofTensor(const Eigen::Matrix3d& rotation, double scale) const {
        const double strength_T = field.config().strength_T;
        const TensorVector unit_T = strength_T * unitTensor(rotation);
        const Eigen::Matrix<double, 5, 3> turn = (scale * strength_T) * unitTensorDerivative(rotation);
        const Eigen::Matrix<double, 5, 3> weighted = system.information() * turn;
        NormalEquations normal;
        normal.information.topLeftCorner<3, 3>() = turn.transpose() * weighted;
        normal.information.topRightCorner<3, 1>() = weighted.transpose() * unit_T;
        normal.information(3, 3) = unit_T.dot(system.information() * unit_T);
        TensorVector pull;
        if (isTensor) {
            // r^T W' r = (x - x_M)^T N (x - x_M) + what the linear fit leaves
            const TensorVector missing_T = tensor_T - scale * unit_T;
            pull = system.information() * missing_T;
            normal.cost = missing_T.dot(pull) + leftOver;
        } else {
            const SphericalReadings residual_T = readings_T - system.design() * (scale * unit_T);
            pull = system.weightedDesign() * residual_T;
            normal.cost = system.chiSquare(residual_T);
        }
        normal.gradient << turn.transpose() * pull, unit_T.dot(pull);
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

/// Solution of the damped equations; the strength is eliminated, or held.
Eigen::Vector4d dampedStep(const NormalEquations& normal, double damping, bool isStrengthFitted) {
    Eigen::Matrix3d turning = normal.information.topLeftCorner<3, 3>();
    // A part of the mean as well: at a singular pose a diagonal entry may vanish.
    const double mean = turning.trace() / 3.0;
    turning.diagonal() *= 1.0 + damping;
    turning.diagonal().array() += 0.1 * damping * mean;
    Eigen::Vector3d pull = normal.gradient.head<3>();
    Eigen::Vector4d step = Eigen::Vector4d::Zero();
    const double own = normal.information(3, 3) * (1.0 + damping);
    const Eigen::Vector3d coupling = normal.information.topRightCorner<3, 1>();
    if (isStrengthFitted) {
        turning -= coupling * coupling.transpose() / own;
        pull -= coupling * (normal.gradient[3] / own);
    }
    const Eigen::Matrix3d inverse = turning.inverse();
    const Eigen::Vector3d turn = inverse * pull;
    step.head<3>() = turn;
    if (isStrengthFitted) {
        step[3] = (normal.gradient[3] - coupling.dot(turn)) / own;
    }
    return step;
}

/// Zero where the equations leave a direction open.
Eigen::Matrix3d covarianceOf(const NormalEquations& normal, const Eigen::Matrix3d& rotation,
                             bool isStrengthFitted) {
    Eigen::Matrix3d turning = normal.information.topLeftCorner<3, 3>();
    if (isStrengthFitted) {
        const Eigen::Vector3d coupling = normal.information.topRightCorner<3, 1>();
        turning -= coupling * coupling.transpose() / normal.information(3, 3);
    }
    // One for independent directions, zero for dependent ones (Hadamard).
    constexpr double LeastIndependence = 1e-10;
    if (!(turning.determinant() > LeastIndependence * turning.diagonal().prod())) {
        return Eigen::Matrix3d::Zero();
    }
    return rotation * turning.inverse() * rotation.transpose();
}

} // namespace

RotationFit fitRotation(const RotorField& field, const SensorPoses& poses, const TensorSystem& system,
                        const SphericalReadings& readings_T, const Eigen::Matrix3d& start,
                        const RotationFitConfig& config) {
    FitModel model{field, poses, system, readings_T};
    RotationFit fit;
    fit.rotation = start;
    // Too few channels for the tensor do not determine its strength either.
    const bool isStrengthFree = config.isStrengthFree && system.isDetermined();
    double scale = 1.0;
    if (system.isDetermined() && !field.hasHarmonics()) {
        model.isTensor = true;
        model.tensor_T = system.solve(readings_T);
        model.leftOver = system.chiSquare(readings_T - system.design() * model.tensor_T);
        scale = isStrengthFree ? strengthOf_T(model.tensor_T) / field.config().strength_T : 1.0;
    }
    // Only near the minimum: far off, a small factor explains any readings better than a wrong pose does.
    bool isStrengthFitted = false;
    double damping = config.firstDamping_ratio;
    NormalEquations normal = model.at(fit.rotation, scale);
    while (fit.iterations < config.iterations) {
        ++fit.iterations;
        const Eigen::Vector4d step = dampedStep(normal, damping, isStrengthFitted);
        const Eigen::Vector3d turn = step.head<3>();
        const Eigen::Matrix3d turned = fit.rotation * rotationOfVector(turn);
        const double nextScale = scale + step[3];
        fit.hasConverged = turn.norm() < config.lastStep_rad && isStrengthFitted == isStrengthFree;
        if (fit.hasConverged) {
            // The equations of the point before serve the covariance: they change by the size of the step.
            fit.rotation = turned;
            scale = nextScale;
            normal.cost = std::fmax(0.0, normal.cost - normal.gradient.dot(step));
            break;
        }
        const NormalEquations next = model.at(turned, nextScale);
        // A negative factor is another pose: the field turned by 90 degrees about the shaft.
        if (nextScale > LeastFactor_ratio * scale && next.cost <= normal.cost) {
            fit.rotation = turned;
            scale = nextScale;
            normal = next;
            damping = std::fmax(0.1 * damping, 1e-15);
            isStrengthFitted = isStrengthFree && (isStrengthFitted || turn.norm() < NearMinimum_rad);
        } else {
            damping *= 10.0;
            if (damping > 1e12) {
                break;
            }
        }
    }
    fit.chiSquare = normal.cost;
    fit.strength_T = scale * field.config().strength_T;
    if (fit.hasConverged) {
        fit.covariance_rad2 = covarianceOf(normal, fit.rotation, isStrengthFree);
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
