#pragma once

#include "app/procedures/calibrate/calibrate_procedure.h"
#include "models/spherical/calibration_fit.h"

namespace halbench::app {

/// "hall": strength, harmonics, gains, skews, offsets, frames and places from a motion that somebody else
/// makes. "stray": field of the coil per ampere, where its current changes in the record. Errors: Usage.
Result<void> checkSensingCalibrate(const devices::Catalogue& catalogue, const CalibrateConfig& config);

CalibratePrediction predictSensingCalibrate(const CalibrateConfig& config, double start_degC);

/// Records a minute of motion and fits all unknowns with the orientation of every sample; nothing is armed.
/// Figures "sensor0.gain_r" ... in SI with intervals; the residuals of the result are the angle by which the
/// values from before err in this record, rms, and the one that is expected with the proposed ones. A motion
/// that does not excite gives the verdict Refused and the orientations that are missing. Restores the board;
/// with `apply` the values are written in one transaction and read back. Errors: as runCalibrate().
Result<CalibrateResult> calibrateSensing(devices::Device& device, const CalibrateConfig& config,
                                         const ProcedureObserver& observer);

/// The same from a recording with nine fields in tesla, with the board's values as they were noted in it.
/// Errors: of sensedMotion(), Usage, OutOfRange, Interrupted.
Result<CalibrateResult> calibrateSensingRecording(const Recording& recording,
                                                  const std::vector<ParameterValue>& noted,
                                                  const CalibrateConfig& config,
                                                  const AbortCheck& checkAbort);

} // namespace halbench::app
