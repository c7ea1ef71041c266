#pragma once

#include "models/spherical/spherical_sensing.h"

#include <array>

namespace halbench::models {

/// One sensor as calibrated: reading = (I + K) diag(gain) axes^T B(position) + offset, K symmetric with the
/// off-diagonal entries `skew`.
struct SensorCalibration {
    SensorPose pose;
    Eigen::Vector3d gain_ratio = Eigen::Vector3d::Ones();
    Eigen::Vector3d skew_ratio = Eigen::Vector3d::Zero(); ///< (R, Theta), (R, Phi), (Theta, Phi)
    Eigen::Vector3d offset_T = Eigen::Vector3d::Zero();

    /// (I + K) diag(gain)
    Eigen::Matrix3d sensitivity() const;
};

/// The whole device as calibrated: the field of the rotor is scaled by 1 + drift (T - reference).
struct SphericalCalibration {
    std::array<SensorCalibration, 3> sensors;
    RotorFieldConfig field;
    double drift_per_K = 0.0;
    double referenceTemperature_degC = 25.0;
    SphericalReadings coil_T_per_A = SphericalReadings::Zero(); ///< in the readings, before correction
};

/// Nominal poses, gains of one, no offsets.
SphericalCalibration nominalCalibration(const SensorPoses& poses, const RotorFieldConfig& field);

/// Readings that ideal sensors at the calibrated poses would give: sensitivity^-1 (reading - coil I -
/// offset).
SphericalReadings correctedReadings_T(const SphericalCalibration& calibration,
                                      const SphericalReadings& readings_T, double coilCurrent_A = 0.0);

/// What an estimator of corrected readings needs; `deviation_T` of every channel.
SphericalSensing sensingOf(const SphericalCalibration& calibration, double deviation_T);

} // namespace halbench::models
