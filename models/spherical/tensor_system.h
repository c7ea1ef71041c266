#pragma once

#include "models/spherical/spherical_sensing.h"

namespace halbench::models {

/// The linear least-squares problem of the field tensor: readings = H x + S b, x the five tensor coordinates,
/// b a uniform field when it is unknown too. Prepared once for the channels in use; b is eliminated from the
/// weights,
///   W' = W - W S (S^T W S)^-1 S^T W,   N = H^T W' H,   x = N^-1 H^T W' readings,
/// W = diag(1/deviation^2), zero for missing channels. No allocation. Source:
/// resources/help/spherical-theory.md section 5.1.
class TensorSystem {
public:
    /// Below this smallest singular value of H (columns of both unknowns, missing rows zero) noise is
    /// amplified thirty times more than by the published placement: the tensor is not determined.
    static constexpr double LeastSingularValue = 0.05;

    explicit TensorSystem(const SphericalSensing& sensing, const ChannelMask& used = AllChannels);

    bool isDetermined() const { return m_smallestSingularValue >= LeastSingularValue; }
    double smallestSingularValue() const { return m_smallestSingularValue; }
    /// Largest over smallest singular value of H.
    double conditioning() const { return m_conditioning; }
    /// Degrees of freedom of the linear fit's chi-square: 4 for all channels without a uniform field.
    int freedom() const { return m_freedom; }
    int channels() const { return m_channels; }

    /// x in tesla; the system is determined.
    TensorVector solve(const SphericalReadings& readings_T) const { return m_solver * readings_T; }
    const Eigen::Matrix<double, 9, 5>& design() const { return m_design; }
    /// W'
    const Eigen::Matrix<double, 9, 9>& weight() const { return m_weight; }
    /// H^T W'
    const Eigen::Matrix<double, 5, 9>& weightedDesign() const { return m_weightedDesign; }
    /// N, and its inverse: the covariance of x (zero when not determined)
    const Eigen::Matrix<double, 5, 5>& information() const { return m_information; }
    const Eigen::Matrix<double, 5, 5>& covariance() const { return m_covariance; }

    /// r^T W' r
    double chiSquare(const SphericalReadings& residual_T) const {
        return residual_T.dot(m_weight * residual_T);
    }
    /// The uniform field (stator frame) that explains a residual best; zero when it is no unknown.
    Eigen::Vector3d uniformField_T(const SphericalReadings& residual_T) const {
        return m_uniformSolver * residual_T;
    }

private:
    Eigen::Matrix<double, 9, 5> m_design;
    Eigen::Matrix<double, 9, 9> m_weight;
    Eigen::Matrix<double, 5, 9> m_weightedDesign;
    Eigen::Matrix<double, 5, 5> m_information;
    Eigen::Matrix<double, 5, 5> m_covariance;
    Eigen::Matrix<double, 5, 9> m_solver;
    Eigen::Matrix<double, 3, 9> m_uniformSolver;
    double m_smallestSingularValue = 0.0;
    double m_conditioning = 0.0;
    int m_freedom = 0;
    int m_channels = 0;
};

/// Readings of a uniform field of 1 T along each stator axis.
Eigen::Matrix<double, 9, 3> uniformFieldDesign(const SensorPoses& poses);

} // namespace halbench::models
