#pragma once

#include "models/spherical/spherical_calibration.h"

#include <optional>
#include <string>
#include <vector>

namespace halbench::models {

enum class CalibrationKind {
    Strength,  ///< q
    Harmonic,  ///< amplitude of one of the field's harmonics
    Gain,      ///< of a channel
    Skew,      ///< entry of K
    Offset,    ///< of a channel
    Turn,      ///< frame of a sensor, rotation vector in stator axes
    Direction, ///< place of a sensor: turned about the centre across its radius
    Drift,     ///< of the field with temperature
    Coil,      ///< field of the coil in a channel
};

/// Unknowns that a calibration fits; the rest keeps its nominal value.
struct CalibrationSelection {
    bool strength = true;
    bool harmonics = false; ///< amplitudes of all terms of the nominal field
    bool gains = true;
    bool skews = false;
    bool offsets = true;
    bool turns = true;
    bool directions = false;
    bool drift = false;
    bool coil = false;
    /// Channels that were read at all: of the others gain, skews, offset and coil field keep their nominal
    /// values, of a sensor without any also frame and place.
    ChannelMask channels = AllChannels;

    bool hasReading(CalibrationKind kind, int sensor, int component) const;
};

/// One unknown: which, and how large an error of it is plausible. The latter is the unit in which the
/// excitation by a motion is judged.
struct CalibrationUnknown {
    CalibrationKind kind = CalibrationKind::Strength;
    int sensor = 0;
    int component = 0;
    double plausible = 1.0; ///< SI
    std::string name;       ///< "gain R of sensor 1"
};
std::vector<CalibrationUnknown> calibrationUnknowns(const CalibrationSelection& selection,
                                                    const SphericalCalibration& nominal);

/// Adds `step` (SI, one entry an unknown) to the calibration.
SphericalCalibration steppedCalibration(const SphericalCalibration& calibration,
                                        const std::vector<CalibrationUnknown>& unknowns,
                                        const Eigen::VectorXd& step);

/// One sample of the recorded motion.
struct CalibrationSample {
    SphericalReadings readings_T = SphericalReadings::Zero();
    ChannelMask used = AllChannels; ///< without clipped channels
    double coilCurrent_A = 0.0;
    double temperature_degC = 25.0;
    std::optional<Eigen::Matrix3d> reference; ///< the orientation, when it is known
};

/// Readings of a calibrated device at one pose and their derivatives.
struct CalibrationPrediction {
    SphericalReadings readings_T;
    Eigen::Matrix<double, 9, Eigen::Dynamic> byUnknown;
    OrientationJacobian byRotation; ///< rotation vector in stator axes
};

/// Field of the rotor with its harmonics prepared, for many poses at one calibration.
class CalibrationModel {
public:
    CalibrationModel(const SphericalCalibration& calibration,
                     const std::vector<CalibrationUnknown>& unknowns);
    CalibrationPrediction at(const Eigen::Matrix3d& rotation, const CalibrationSample& sample) const;

private:
    Eigen::Vector3d fieldChange(const CalibrationUnknown& unknown, const Eigen::Matrix3d& rotation,
                                int sensor) const;

    const SphericalCalibration& m_calibration;
    const std::vector<CalibrationUnknown>& m_unknowns;
    RotorField m_field;
    SphericalHarmonicSeries m_harmonics;
    SensorPoses m_places; ///< axes of the stator, so that fields come in its frame
};

} // namespace halbench::models
