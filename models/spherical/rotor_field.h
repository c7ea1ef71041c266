#pragma once

#include "models/fields/spherical_harmonic_term.h"
#include "models/spherical/sensor_placement.h"

#include <vector>

namespace halbench::models {

/// Derivatives of the nine readings with respect to a small rotation w (stator frame) of the rotor,
/// M -> exp([w]x) M, T/rad.
using OrientationJacobian = Eigen::Matrix<double, 9, 3>;

/// Orthonormal basis of the symmetric traceless 3x3 matrices (Frobenius product): every Q = sum x_k E_k.
using TensorVector = Eigen::Matrix<double, 5, 1>;
Eigen::Matrix3d tensorOf(const TensorVector& coordinates);
TensorVector tensorCoordinates(const Eigen::Matrix3d& tensor);

/// Field tensor of the rotor: Q = q M diag(1, -1, 0) M^T = q (u u^T - v v^T).
Eigen::Matrix3d rotorTensor_T(double strength_T, const Eigen::Matrix3d& rotation);

/// Derivative of tensorCoordinates(Q) with respect to the rotation vector w: column k belongs to
/// E_k Q - Q E_k with E_k = [e_k]x.
Eigen::Matrix<double, 5, 3> tensorRotationDerivative(const Eigen::Matrix3d& tensor);

/// H: readings of the nine channels per unit of the five tensor coordinates. Row of a channel with axis t at
/// p = r n: (r_ref/r)^4 (5 (n.t) n.E_k n - 2 t.E_k n).
Eigen::Matrix<double, 9, 5> tensorDesign(const SensorPoses& poses, double referenceRadius_m);

/// The field frozen in the rotor: strength of the degree-2 tensor and further harmonics.
struct RotorFieldConfig {
    double strength_T = 0.0991864782; ///< q, at the reference radius
    double referenceRadius_m = 0.05;
    std::vector<SphericalHarmonicTerm> harmonics; ///< amplitudes at the reference radius
};

/// Exact readings of ideal sensors at given poses in the field of the turned rotor. Immutable, no allocation
/// when evaluated.
class RotorField {
public:
    explicit RotorField(const RotorFieldConfig& config);

    const RotorFieldConfig& config() const { return m_config; }
    bool hasHarmonics() const { return !m_harmonics.isEmpty(); }

    /// B at a point outside the rotor, both in the stator frame.
    Eigen::Vector3d field_T(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& point_m) const;
    /// axes^T B of the three sensors.
    SphericalReadings readings_T(const Eigen::Matrix3d& rotation, const SensorPoses& poses) const;
    /// The part of the readings that the harmonics beyond the tensor make; zero without them.
    SphericalReadings harmonicReadings_T(const Eigen::Matrix3d& rotation, const SensorPoses& poses) const;
    /// Readings and their derivative in one pass. For harmonics: dB = w x B - G (w x p), G gradient of B.
    SphericalReadings readingsAndJacobian(const Eigen::Matrix3d& rotation, const SensorPoses& poses,
                                          OrientationJacobian& jacobian_T_per_rad) const;

private:
    RotorFieldConfig m_config;
    SphericalHarmonicSeries m_harmonics;
};

} // namespace halbench::models
