#pragma once

#include "models/spherical/calibration_unknowns.h"

#include <functional>
#include <span>

namespace halbench::models {

struct CalibrationConfig {
    CalibrationSelection selection;
    double deviation_T = 100e-6;              ///< noise of a reading, rms
    double referenceDeviation_rad = 1.745e-4; ///< of known orientations, each axis: 0.01 degrees
    /// How far the places lie from their nominal directions, rms: what is known of them before the motion.
    std::optional<double> placeDeviation_rad;
    int iterations = 40;
    std::function<bool()> isStopped; ///< asked once an iteration; empty: never
};

/// A value with its 95 % interval, in the order of the unknowns. Values are those of the calibration: q,
/// amplitude, gain, skew, offset, drift, coil field; turns and directions relative to the nominal ones.
struct CalibratedValue {
    CalibrationUnknown unknown;
    double value = 0.0;
    double half95 = 0.0;
};

struct CalibrationFit {
    SphericalCalibration calibration;
    std::vector<CalibratedValue> values;
    Eigen::MatrixXd covariance; ///< of the values, SI, widened as the intervals are
    double chiSquare = 0.0;     ///< of all readings with `deviation_T`
    double freedom = 0.0;
    /// The readings scatter by this factor more than expected; intervals are widened by it when above one.
    double excess_ratio = 1.0;
    int iterations = 0;
    std::vector<Eigen::Matrix3d> rotation; ///< of each sample that could be oriented
    std::vector<std::size_t> sample;       ///< which ones these are
    double deviation_T = 0.0;              ///< of a reading, as the data show it
    /// Samples whose readings still lie far beyond the scatter of the others, each more than eight times
    /// their median chi-square.
    std::size_t strange = 0;
    bool isStrangeLeftOut = false;
    /// What these data cannot tell, one sentence each: the common scale of all gains beside q; a common
    /// rotation of the stator frame when places are fitted without known orientations.
    std::vector<std::string> notes;
};

/// How well a motion determines the unknowns, each in units of its plausible error.
struct CalibrationExcitation {
    double weakest_ratio = 0.0; ///< 95 % half-width of the worst determined combination
    Eigen::VectorXd weakest;    ///< that combination, SI, at its plausible size
    std::string name;           ///< of its largest part
    bool isEnough() const { return weakest_ratio < 0.5; }
};
/// At the nominal calibration and the orientations that it estimates; cheap enough for a live display. Error:
/// Refused with fewer than 20 samples that can be oriented.
Result<CalibrationExcitation> calibrationExcitation(const SphericalCalibration& nominal,
                                                    std::span<const CalibrationSample> samples,
                                                    const CalibrationConfig& config);

/// What a further sample at this orientation adds to the weakest combination: its signal to noise squared
/// that no rotation explains. The orientations with the largest values still need data.
double calibrationGain(const SphericalCalibration& nominal, const CalibrationExcitation& excitation,
                       const CalibrationConfig& config, const Eigen::Matrix3d& rotation);

/// Least squares over all unknowns and the orientation of every sample (Gauss-Newton, the orientations
/// eliminated sample by sample), from the nominal calibration; samples on a wrong branch are oriented anew by
/// what was found. Known orientations enter with their deviation.
/// Gauges: with q and gains the mean gain stays one; with directions and turns and no reference the mean turn
/// stays zero, unless the deviation of the places is known. Errors: Refused when fewer than 20 samples can be
/// oriented, when the rotor moved less than 10 degrees, or when the 95 % half-width of some combination
/// exceeds half its plausible size (the message names it); OutOfRange for a deviation of zero or less;
/// Interrupted. Source: resources/help/spherical-theory.md section 8.
Result<CalibrationFit> calibrate(const SphericalCalibration& nominal,
                                 std::span<const CalibrationSample> samples, const CalibrationConfig& config);

} // namespace halbench::models
