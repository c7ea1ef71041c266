#pragma once

#include "app/procedures/base/procedure.h"
#include "control/identify/joint_estimate.h"
#include "devices/device.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace halbench::app {

enum class Calibration { Hall, Stray, StaticFriction };

/// "hall", "stray", "static-friction"
std::string_view calibrationName(Calibration calibration);

struct CalibrateConfig {
    std::vector<Calibration> which{Calibration::Hall, Calibration::Stray, Calibration::StaticFriction};
    bool apply = false;             ///< write what is proposed, verify, keep
    double spinCurrent_A = 2.2;     ///< slow constant speed for the sensor ellipse
    double mapCurrent_A = 4.0;      ///< fast run-ups for the angle error that the ellipse leaves
    double strayCurrent_A = 4.0;    ///< largest d-axis current
    double frictionCurrent_A = 3.0; ///< end of the static-friction ramp
    int frictionStarts = 6;         ///< angles at which the rotor is broken loose, each direction
    double speedLimit_rad_s = 40.0;
    std::uint64_t seed = 1;
};

/// One figure that a calibration found, e.g. "hall.offset_a" in T.
struct CalibrationFigure {
    std::string name;
    std::string unit;
    control::Estimate estimate;
};

struct StaticFrictionPoint {
    double angle_rad = 0.0;
    double current_A = 0.0; ///< at the first motion, signed
};

/// Reading of the two Hall sensors in slow motion, without the field of the phase currents.
struct HallPoint {
    double a_T = 0.0;
    double b_T = 0.0;
};

/// `halbench.calibration/1`: what was found, which parameter values are proposed, what they were.
struct CalibrateResult {
    std::vector<CalibrationFigure> figures;
    std::vector<ParameterValue> before;
    std::vector<ParameterValue> proposed;
    bool isApplied = false;
    double residualBefore_rad = 0.0; ///< rms angle error from the ellipse with the old values
    double residualAfter_rad = 0.0;
    std::vector<StaticFrictionPoint> staticFriction;
    std::vector<HallPoint> hallPoints; ///< some hundred of those that the ellipse was fitted to
    DataQuality quality;
    double duration_s = 0.0; ///< device time that it took; 0: a file of an older version does not say
};

/// Runs the chosen calibrations one after the other. The board's parameters are restored unless `apply` is
/// set and the values were verified by read-back. Errors: of the device and the abort; a figure that the data
/// do not support is left out and named in the findings.
Result<CalibrateResult> runCalibrate(devices::Device& device, const CalibrateConfig& config,
                                     const ProcedureObserver& observer);

/// The measuring part of a calibration: figures, findings and proposed values into `result`.
using CalibrationMeasurement = Result<void> (*)(devices::Device& device, const CalibrateConfig& config,
                                                const ProcedureObserver& observer, CalibrateResult& result);

/// Run of any calibration around its measurement: measures with the board's parameters kept, reads what the
/// proposed values replace, and with `apply` writes them in one transaction, read back. Errors: as
/// runCalibrate().
Result<CalibrateResult> guardedCalibration(devices::Device& device, const CalibrateConfig& config,
                                           const ProcedureObserver& observer, CalibrationMeasurement measure);

/// Duration, current and travel of the chosen calibrations, before anything is armed (also for `run
/// --dry-run`), for a motor with the published constants.
struct CalibratePrediction {
    double duration_s = 0.0;
    double peakCurrent_A = 0.0;
    double meanSquare_A2 = 0.0; ///< in the phase that carries most
};
CalibratePrediction predictCalibrate(const CalibrateConfig& config);

} // namespace halbench::app
