#pragma once

#include "models/spherical/additive_model.h"
#include "models/spherical/spherical_sensing.h"

#include <optional>

namespace halbench::models {

/// Derivative of estimated angles (alpha, beta, gamma) by the nine readings, rad/T. Zero columns: readings
/// that the estimate does not use.
using AngleGain = Eigen::Matrix<double, 3, ChannelCount>;

/// Gain of additiveInverse() at the model's own readings of the pose: with (Theta, Phi) pairs T0, T1, c = cos
/// 2 gamma, s = sin 2 gamma and U, V as there,
///   dgamma = (c dR1 - s dR0)/(6 q cos^2 b),
///   dU = c dT0 + s dT1 + 2 V dgamma,   dV = c dT1 - s dT0 - 2 U dgamma,
///   dalpha = -(cos a, sin a).dV/(2 q cos b),   dcos = (-sin a, cos a).dV/(2 q),
///   dbeta = -(cos a, sin a).dU/(2 q) - 2 sin b dcos.
/// Not finite for beta = +-90 degrees.
AngleGain inverseGain(double strength_T, const OrientationAngles& angles);

/// (J^T J)^-1 J^T over the channels used, J the model's derivatives by the angles: of least squares, and of
/// the zero of three residuals. Empty where J does not determine the angles: its smallest singular value
/// below `cut_ratio` of the largest.
std::optional<AngleGain> leastSquaresGain(const OrientationJacobian& jacobian, const ChannelMask& used,
                                          double cut_ratio = 1e-3);

/// Estimate of the angles, and the readings that decide it.
struct AdditiveEstimate {
    OrientationAngles angles;
    ChannelMask channels = AllChannels; ///< readings that decide the angles
    bool isInverse = false;             ///< of additiveInverse(); else the angles explain these readings best
};

/// Why an estimate has no uncertainty.
enum class UncertaintyGap {
    None,
    Singular,   ///< the readings used do not determine the angles here
    NotSettled, ///< the search ended elsewhere than at the angles that its readings say
    Misfit      ///< the model leaves so much unexplained that first order says nothing
};

/// First-order uncertainty of an estimate of the additive model.
struct AdditiveUncertainty {
    UncertaintyGap gap = UncertaintyGap::None;
    /// Of the rotation vector in stator axes: A (s^2 G G^T + d d^T) A^T, A = rateMatrix. s is the deviation
    /// of the readings, or what the model leaves unexplained where that is beyond its 99 % quantile; d is how
    /// far the angles of a physical rotor would lie, where the readings do not tell by 20 to 1 that it is
    /// none.
    Eigen::Matrix3d covariance_rad2 = Eigen::Matrix3d::Zero();
    double chiSquare = 0.0; ///< of the residuals that no angles explain, with 6 degrees of freedom
};
/// `physical`: where the sensors are. `deviation_T` of every reading, all their errors together. Source:
/// resources/help/spherical-theory.md section 5.5.
AdditiveUncertainty additiveUncertainty(const AdditiveModel& model, const SensorPoses& physical,
                                        const AdditiveEstimate& estimate, const SphericalReadings& readings_T,
                                        double deviation_T);
constexpr int AdditiveFreedom = ChannelCount - 3;

} // namespace halbench::models
