#pragma once

#include "models/spherical/rotation_fit.h"

#include <string_view>

namespace halbench::models {

/// Estimators of the physical (exact) device model.
enum class OrientationMethod {
    Tensor,             ///< linear tensor, eigenvectors
    Projector,          ///< linear tensor, projectors instead of eigenvectors: fastest
    TensorRefined,      ///< tensor by projectors with one Gauss-Newton step
    LevenbergMarquardt, ///< rotation fit from the tensor solution, fallback starts when it is not accepted
};
inline constexpr std::array<std::string_view, 4> OrientationMethodNames = {"tensor", "projector", "refined",
                                                                           "lm"};

enum class OrientationVerdict {
    Determined,
    Reduced,       ///< too few channels for the tensor; found by search with the known strength
    Ambiguous,     ///< the channels left explain more than one pose
    NotDetermined, ///< fewer than four channels, or readings without a field
    NotConverged,  ///< no pose explains the readings
};

struct OrientationEstimate {
    OrientationVerdict verdict = OrientationVerdict::NotDetermined;
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity(); ///< see representative()
    double strength_T = 0.0;                                ///< q as fitted or held
    /// Of the rotation vector in stator axes. First order in the noise of the channels.
    Eigen::Matrix3d covariance_rad2 = Eigen::Matrix3d::Zero();
    double chiSquare = 0.0; ///< of the linear fit, or of the rotation fit for LevenbergMarquardt and Reduced
    int freedom = 0;
    SphericalReadings residual_T = SphericalReadings::Zero();
    Eigen::Vector3d uniformField_T = Eigen::Vector3d::Zero(); ///< stator frame, when it is an unknown
    Eigen::Matrix3d other = Eigen::Matrix3d::Identity();      ///< a second pose, when Ambiguous
};

struct OrientationConfig {
    OrientationMethod method = OrientationMethod::TensorRefined;
    /// Tensor methods: harmonics predicted and subtracted this often. Where that does not settle, or the
    /// result is far from the uncorrected one and does not explain the readings, the rotation fit decides.
    int harmonicPasses = 0;
    /// Rotation fit: accepted up to this chi-square. 1e-9 of healthy readings exceed it (5 degrees of
    /// freedom).
    double chiSquareLimit = 50.2;
    /// A pose is possible up to this many times that limit. Above 1 for sensors whose gains, offsets and
    /// places are not exact: 1 + (their error / noise)^2.
    double possibleLimit_ratio = 1.0;
    /// Also for the tensor methods: with a free strength the Gauss-Newton step fits it and the predicted
    /// harmonics are scaled by it; held, both take the known one (3 % less noise, but a drift of q enters).
    RotationFitConfig fit;
};

/// Orientation from nine readings of any device, without a start value. Prepared once; estimating allocates
/// nothing and is safe from several threads. Source: resources/help/spherical-theory.md section 5.
class OrientationEstimator {
public:
    /// Errors: of checkSphericalSensing(); OutOfRange when even all channels do not determine the tensor or
    /// the number of passes is negative.
    static Result<OrientationEstimator> make(const SphericalSensing& sensing,
                                             const OrientationConfig& config);

    /// The bare solution of a tensor method from all channels, harmonic passes included: rotation and q.
    Eigen::Matrix3d solve(const SphericalReadings& readings_T, double& strength_T) const;
    /// With verdict, uncertainty and residuals. Channels not in use have no weight.
    OrientationEstimate estimate(const SphericalReadings& readings_T,
                                 const ChannelMask& used = AllChannels) const;

    const SphericalSensing& sensing() const { return m_sensing; }
    const OrientationConfig& config() const { return m_config; }
    const TensorSystem& system() const { return m_system; }

private:
    OrientationEstimator(const SphericalSensing& sensing, const OrientationConfig& config);
    Eigen::Matrix3d solveWith(const TensorSystem& system, const SphericalReadings& readings_T,
                              double& strength_T) const;
    Eigen::Matrix3d onePass(const TensorSystem& system, const SphericalReadings& readings_T,
                            double& strength_T) const;
    double harmonicScale(double strength_T) const;
    bool hasSettled(const TensorSystem& system, const SphericalReadings& readings_T,
                    const OrientationEstimate& estimate) const;
    OrientationEstimate byTensor(const TensorSystem& system, const SphericalReadings& readings_T) const;
    OrientationEstimate byFit(const TensorSystem& system, const SphericalReadings& readings_T) const;

    SphericalSensing m_sensing;
    OrientationConfig m_config;
    RotorField m_field;
    TensorSystem m_system;
};

} // namespace halbench::models
