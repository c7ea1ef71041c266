#include "models/spherical/additive_uncertainty.h"

#include "control/base/distributions.h"
#include "models/spherical/angle_model.h"
#include "models/spherical/orientation.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace halbench::models {

AngleGain inverseGain(double strength_T, const OrientationAngles& angles) {
    const double q = strength_T;
    const double c = std::cos(2.0 * angles.gamma_rad);
    const double s = std::sin(2.0 * angles.gamma_rad);
    const double cosine = std::cos(angles.beta_rad);
    const double sine = std::sin(angles.beta_rad);
    const Eigen::Vector2d along(std::cos(angles.alpha_rad), std::sin(angles.alpha_rad));
    const Eigen::Vector2d across(-along[1], along[0]);
    const Eigen::Vector2d tilted_T = -2.0 * q * sine * cosine * along; // U
    const Eigen::Vector2d upright_T = 2.0 * q * cosine * across;       // V
    AngleGain gain = AngleGain::Zero();
    for (Eigen::Index channel = 0; channel < 6; ++channel) {
        const Eigen::Index k = channel % 3;
        const bool isMain = channel < 3;
        Eigen::Vector2d tilted = Eigen::Vector2d::Zero();
        Eigen::Vector2d upright = Eigen::Vector2d::Zero();
        double gamma = 0.0;
        if (k == 0) {
            gamma = (isMain ? -s : c) / (6.0 * q * cosine * cosine);
            tilted = 2.0 * gamma * upright_T;
            upright = -2.0 * gamma * tilted_T;
        } else {
            tilted[k - 1] = isMain ? c : s;
            upright[k - 1] = isMain ? -s : c;
        }
        const double dCosine = across.dot(upright) / (2.0 * q);
        gain(0, channel) = -along.dot(upright) / (2.0 * q * cosine);
        gain(1, channel) = -along.dot(tilted) / (2.0 * q) - 2.0 * sine * dCosine;
        gain(2, channel) = gamma;
    }
    return gain;
}

std::optional<AngleGain> leastSquaresGain(const OrientationJacobian& jacobian, const ChannelMask& used,
                                          double cut_ratio) {
    OrientationJacobian taken = jacobian;
    for (std::size_t c = 0; c < used.size(); ++c) {
        if (!used[c]) {
            taken.row(static_cast<Eigen::Index>(c)).setZero();
        }
    }
    const Eigen::JacobiSVD<OrientationJacobian> svd(taken, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::Vector3d singular = svd.singularValues();
    if (!(singular[2] > cut_ratio * singular[0])) {
        return std::nullopt;
    }
    return svd.matrixV() * singular.cwiseInverse().asDiagonal() * svd.matrixU().leftCols<3>().transpose();
}

namespace {

/// Shares of the angles' own deviation that a search may still be away from its end.
constexpr double Settled_ratio = 0.1;
constexpr double Unlikely = 0.01;
/// Residuals over the readings' deviation that may still be its own scatter; beyond, the model is wrong in
/// some way of its own, and not alike along and across the angles.
constexpr double LargestMisfit_ratio = 3.0;
/// Readings are those of the additive model when it explains them 20 times better than a physical rotor.
constexpr double SureLogOdds = 2.995732273553991;

std::optional<AngleGain> gainOf(const AdditiveModel& model, const AdditiveEstimate& estimate,
                                const OrientationJacobian& jacobian) {
    if (!estimate.isInverse) {
        return leastSquaresGain(jacobian, estimate.channels);
    }
    const AngleGain gain = inverseGain(model.strength_T, estimate.angles);
    return gain.allFinite() ? std::optional(gain) : std::nullopt;
}

/// Variance of the readings' errors as the residuals show it.
double shownVariance_T2(const OrientationJacobian& jacobian, const AngleGain& gain,
                        const SphericalReadings& residual_T, double acrossSquares_T2) {
    using Square = Eigen::Matrix<double, ChannelCount, ChannelCount>;
    const Square left = Square::Identity() - jacobian * gain;
    return std::max(acrossSquares_T2 / AdditiveFreedom, residual_T.squaredNorm() / left.squaredNorm());
}

/// The same readings as those of sensors on a physical rotor.
struct PhysicalReading {
    Eigen::Vector3d shift_rad = Eigen::Vector3d::Zero(); ///< of the angles that explain them best
    double unexplained_T2 = 0.0;                         ///< that no angles explain
};

/// One Gauss-Newton step of the physical model from the angles of the additive one.
PhysicalReading physicalReading(const AdditiveModel& model, const SensorPoses& physical,
                                const OrientationAngles& angles, const SphericalReadings& readings_T) {
    RotorFieldConfig field;
    field.referenceRadius_m = physical[0].position_m.norm();
    field.strength_T = model.strength_T;
    OrientationJacobian jacobian;
    const SphericalReadings residual_T =
        readings_T - angleModel(RotorField(field), physical)(angles, &jacobian);
    PhysicalReading reading;
    if (const std::optional<AngleGain> gain = leastSquaresGain(jacobian, AllChannels)) {
        reading.shift_rad = *gain * residual_T;
        reading.unexplained_T2 = (residual_T - jacobian * reading.shift_rad).squaredNorm();
    }
    return reading;
}

} // namespace

AdditiveUncertainty additiveUncertainty(const AdditiveModel& model, const SensorPoses& physical,
                                        const AdditiveEstimate& estimate, const SphericalReadings& readings_T,
                                        double deviation_T) {
    AdditiveUncertainty uncertainty;
    OrientationJacobian jacobian;
    const SphericalReadings residual_T =
        readings_T - additiveReadingsAndJacobian(model, estimate.angles, jacobian);
    // Errors of the angles leave residuals along J; across it lie six combinations that no angles explain.
    const Eigen::JacobiSVD<OrientationJacobian> svd(jacobian, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const double across_T2 =
        (svd.matrixU().rightCols<AdditiveFreedom>().transpose() * residual_T).squaredNorm();
    double variance_T2 = deviation_T * deviation_T;
    uncertainty.chiSquare = across_T2 / variance_T2;
    const std::optional<AngleGain> gain = gainOf(model, estimate, jacobian);
    if (!gain) {
        uncertainty.gap =
            estimate.channels == ChannelMask{} ? UncertaintyGap::NotSettled : UncertaintyGap::Singular;
        return uncertainty;
    }
    const double ownDeviation_rad = deviation_T * gain->norm();
    if (!estimate.isInverse && (*gain * residual_T).norm() > Settled_ratio * ownDeviation_rad) {
        uncertainty.gap = UncertaintyGap::NotSettled;
        return uncertainty;
    }
    if (control::chiSquareTail(uncertainty.chiSquare, AdditiveFreedom) < Unlikely) {
        const double shown_T2 = shownVariance_T2(jacobian, *gain, residual_T, across_T2);
        if (shown_T2 > LargestMisfit_ratio * LargestMisfit_ratio * variance_T2) {
            uncertainty.gap = UncertaintyGap::Misfit;
            return uncertainty;
        }
        variance_T2 = std::max(variance_T2, shown_T2);
    }
    Eigen::Matrix3d angles_rad2 = variance_T2 * *gain * gain->transpose();
    const PhysicalReading other = physicalReading(model, physical, estimate.angles, readings_T);
    if (other.unexplained_T2 - across_T2 < 2.0 * SureLogOdds * variance_T2) {
        angles_rad2 += other.shift_rad * other.shift_rad.transpose();
    }
    const Eigen::Matrix3d rates = rateMatrix(estimate.angles);
    uncertainty.covariance_rad2 = rates * angles_rad2 * rates.transpose();
    return uncertainty;
}

} // namespace halbench::models
