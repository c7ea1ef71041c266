#pragma once

#include "app/actuators/spherical/sensing_board.h"
#include "app/actuators/spherical/sensing_motion.h"
#include "app/procedures/calibrate/calibrate_procedure.h"
#include "models/spherical/calibration_fit.h"

namespace halbench::app {

/// Unknowns that such a motion can determine: drift with a changing temperature, with `isStray` the coil's
/// field with a changing current; places by their tolerance.
models::CalibrationConfig sensingFitConfig(const SensedMotion& motion, const SensingBoard& board,
                                           bool isStray);

/// Fits the calibration to a motion and puts figures, proposed values and findings into `result`. Errors:
/// Interrupted, OutOfRange; a motion that does not determine the values is a finding.
Result<void> concludeSensing(const SensedMotion& motion, const SensingBoard& board,
                             const CalibrateConfig& config, const AbortCheck& checkAbort,
                             CalibrateResult& result);

} // namespace halbench::app
