#include "models/spherical/orientation_estimator.h"

#include "models/spherical/orientation.h"
#include "models/spherical/tensor_rotation.h"

#include <Eigen/LU>
#include <algorithm>

namespace halbench::models {
namespace {

/// A tensor weaker than this share of the known one has no field to orient by.
constexpr double LeastStrength_ratio = 0.05;
/// A further pass moves a settled estimate by less; four passes leave 1e-6 with weak harmonics.
constexpr double SettledStep_rad = 1e-3;
/// Harmonics that turn the estimate by less have no second pose: those of preset H1 turn it by 1.1 degrees.
constexpr double SmallCorrection_rad = 0.05;
/// Three unknowns and one channel to test them.
constexpr int LeastChannels = 4;

} // namespace

Result<OrientationEstimator> OrientationEstimator::make(const SphericalSensing& sensing,
                                                        const OrientationConfig& config) {
    if (auto checked = checkSphericalSensing(sensing); !checked) {
        return failure(checked.error());
    }
    if (config.harmonicPasses < 0 || config.fit.iterations < 1 || config.chiSquareLimit <= 0.0 ||
        config.possibleLimit_ratio < 1.0) {
        return failure(ErrorCode::OutOfRange,
                       "The estimator needs harmonic passes of at least 0, at least one "
                       "iteration and a positive limit of chi-square.");
    }
    OrientationEstimator estimator(sensing, config);
    if (!estimator.m_system.isDetermined()) {
        return failure(ErrorCode::OutOfRange, "The sensors do not determine the field of the rotor.",
                       "Two of them need directions that differ and are not opposite.");
    }
    return estimator;
}

OrientationEstimator::OrientationEstimator(const SphericalSensing& sensing, const OrientationConfig& config)
    : m_sensing(sensing), m_config(config), m_field(sensing.field), m_system(sensing) {}

Eigen::Matrix3d OrientationEstimator::onePass(const TensorSystem& system, const SphericalReadings& readings_T,
                                              double& strength_T) const {
    const TensorVector tensor_T = system.solve(readings_T);
    strength_T = strengthOf_T(tensor_T);
    if (m_config.method == OrientationMethod::Tensor ||
        m_config.method == OrientationMethod::LevenbergMarquardt) {
        return rotationByEigenvectors(tensor_T);
    }
    Eigen::Matrix3d rotation = rotationByProjectors(tensor_T);
    if (m_config.method == OrientationMethod::TensorRefined) {
        if (m_config.fit.isStrengthFree) {
            refineRotationAndStrength(tensor_T, system.information(), rotation, strength_T);
        } else {
            strength_T = m_sensing.field.strength_T;
            refineRotation(tensor_T, system.information(), strength_T, rotation);
        }
    }
    return rotation;
}

double OrientationEstimator::harmonicScale(double strength_T) const {
    // The harmonics change with the magnet's strength as the tensor does.
    return m_config.fit.isStrengthFree ? strength_T / m_sensing.field.strength_T : 1.0;
}

Eigen::Matrix3d OrientationEstimator::solveWith(const TensorSystem& system,
                                                const SphericalReadings& readings_T,
                                                double& strength_T) const {
    Eigen::Matrix3d rotation = onePass(system, readings_T, strength_T);
    for (int i = 0; i < m_config.harmonicPasses && m_field.hasHarmonics(); ++i) {
        const double scale = harmonicScale(strength_T);
        rotation = onePass(system, readings_T - scale * m_field.harmonicReadings_T(rotation, m_sensing.poses),
                           strength_T);
    }
    return rotation;
}

Eigen::Matrix3d OrientationEstimator::solve(const SphericalReadings& readings_T, double& strength_T) const {
    return solveWith(m_system, readings_T, strength_T);
}

OrientationEstimate OrientationEstimator::byTensor(const TensorSystem& system,
                                                   const SphericalReadings& readings_T) const {
    OrientationEstimate estimate;
    estimate.verdict = OrientationVerdict::Determined;
    estimate.rotation = solveWith(system, readings_T, estimate.strength_T);
    SphericalReadings linear_T = readings_T;
    if (m_config.harmonicPasses > 0) {
        linear_T -= harmonicScale(estimate.strength_T) *
                    m_field.harmonicReadings_T(estimate.rotation, m_sensing.poses);
    }
    const bool isStrengthHeld =
        m_config.method == OrientationMethod::TensorRefined && !m_config.fit.isStrengthFree;
    // A strength that is held is part of the model: readings of another magnet must not fit it.
    const TensorVector tensor_T = isStrengthHeld
                                      ? TensorVector(estimate.strength_T * unitTensor(estimate.rotation))
                                      : system.solve(linear_T);
    estimate.residual_T = linear_T - system.design() * tensor_T;
    estimate.freedom = system.freedom() + (isStrengthHeld ? 2 : 0);
    Eigen::Matrix3d own = Eigen::Matrix3d::Zero();
    if (m_config.method == OrientationMethod::TensorRefined) {
        Eigen::Matrix<double, 5, 4> slope;
        slope << estimate.strength_T * unitTensorDerivative(estimate.rotation), unitTensor(estimate.rotation);
        const Eigen::Matrix4d normal = slope.transpose() * system.information() * slope;
        own = m_config.fit.isStrengthFree ? Eigen::Matrix3d(normal.inverse().topLeftCorner<3, 3>())
                                          : Eigen::Matrix3d(normal.topLeftCorner<3, 3>().inverse());
    } else {
        const Eigen::Matrix<double, 3, 5> sensitivity =
            m_config.method == OrientationMethod::Projector
                ? projectorSensitivity(estimate.rotation, estimate.strength_T)
                : eigenvectorSensitivity(estimate.rotation, estimate.strength_T);
        own = sensitivity * system.covariance() * sensitivity.transpose();
    }
    estimate.covariance_rad2 = estimate.rotation * own * estimate.rotation.transpose();
    return estimate;
}

bool OrientationEstimator::hasSettled(const TensorSystem& system, const SphericalReadings& readings_T,
                                      const OrientationEstimate& estimate) const {
    double strength_T = 0.0;
    const double scale = harmonicScale(estimate.strength_T);
    const SphericalReadings harmonic_T =
        scale * m_field.harmonicReadings_T(estimate.rotation, m_sensing.poses);
    const Eigen::Matrix3d next = onePass(system, readings_T - harmonic_T, strength_T);
    if (symmetricError_rad(next, estimate.rotation) > SettledStep_rad) {
        return false;
    }
    return system.chiSquare(estimate.residual_T) <= m_config.chiSquareLimit ||
           symmetricError_rad(onePass(system, readings_T, strength_T), estimate.rotation) <
               SmallCorrection_rad;
}

OrientationEstimate OrientationEstimator::byFit(const TensorSystem& system,
                                                const SphericalReadings& readings_T) const {
    const bool isWhole = system.isDetermined();
    Eigen::Matrix3d start = fallbackStart(0);
    if (isWhole) {
        double strength_T = 0.0;
        start = solveWith(system, readings_T, strength_T);
    }
    const double possible = m_config.chiSquareLimit * m_config.possibleLimit_ratio;
    RotationSearch search;
    if (isWhole) {
        search = searchRotation(m_field, m_sensing.poses, system, readings_T, start, m_config.chiSquareLimit,
                                false, m_config.fit);
    }
    // Where errors of the sensors hide which of several poses is the true one, all that are possible count.
    if (!search.isAccepted && (!isWhole || possible > m_config.chiSquareLimit)) {
        search = searchRotation(m_field, m_sensing.poses, system, readings_T, start, possible,
                                !isWhole || m_field.hasHarmonics(), m_config.fit);
    }
    OrientationEstimate estimate;
    estimate.rotation = search.best.rotation;
    estimate.strength_T = search.best.strength_T;
    estimate.covariance_rad2 = search.best.covariance_rad2;
    const bool isStrengthFree = isWhole && m_config.fit.isStrengthFree;
    estimate.freedom = system.channels() - (isStrengthFree ? 4 : 3) - (m_sensing.hasUniformField ? 3 : 0);
    estimate.residual_T = readings_T - estimate.strength_T / m_sensing.field.strength_T *
                                           m_field.readings_T(estimate.rotation, m_sensing.poses);
    estimate.other = search.other;
    if (!search.isAccepted) {
        estimate.verdict = OrientationVerdict::NotConverged;
    } else if (search.isAmbiguous || estimate.covariance_rad2.isZero(0.0)) {
        estimate.verdict = OrientationVerdict::Ambiguous;
    } else {
        estimate.verdict = isWhole ? OrientationVerdict::Determined : OrientationVerdict::Reduced;
    }
    return estimate;
}

OrientationEstimate OrientationEstimator::estimate(const SphericalReadings& readings_T,
                                                   const ChannelMask& used) const {
    const bool isAll = used == AllChannels;
    const TensorSystem masked = isAll ? m_system : TensorSystem(m_sensing, used);
    OrientationEstimate estimate;
    // Without weight a missing reading may be anything, even not a number.
    SphericalReadings present_T = readings_T;
    for (int i = 0; i < ChannelCount; ++i) {
        present_T[i] = used[static_cast<std::size_t>(i)] ? readings_T[i] : 0.0;
    }
    const bool hasField =
        masked.isDetermined()
            ? strengthOf_T(masked.solve(present_T)) > LeastStrength_ratio * m_sensing.field.strength_T
            : masked.channels() >= LeastChannels && !m_sensing.hasUniformField;
    if (!present_T.allFinite() || !hasField) {
        return estimate;
    }
    const bool isFit = m_config.method == OrientationMethod::LevenbergMarquardt || !masked.isDetermined();
    estimate = isFit ? byFit(masked, present_T) : byTensor(masked, present_T);
    if (!isFit && m_config.harmonicPasses > 0 && m_field.hasHarmonics() &&
        !hasSettled(masked, present_T, estimate)) {
        estimate = byFit(masked, present_T);
    }
    estimate.uniformField_T = masked.uniformField_T(estimate.residual_T);
    for (int i = 0; i < ChannelCount; ++i) {
        estimate.residual_T[i] = used[static_cast<std::size_t>(i)] ? estimate.residual_T[i] : 0.0;
    }
    estimate.chiSquare = masked.chiSquare(estimate.residual_T);
    if (m_sensing.hasUniformField) {
        estimate.residual_T -= uniformFieldDesign(m_sensing.poses) * estimate.uniformField_T;
    }
    return estimate;
}

} // namespace halbench::models
