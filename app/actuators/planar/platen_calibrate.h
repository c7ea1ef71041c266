#pragma once

#include "app/procedures/calibrate/calibrate_procedure.h"

namespace halbench::app {

/// "hall": amplitude, gain, offset, cross-axis and place of the chips from travels over more than a pitch
/// each way. "stray": field of the coil currents at the chips, from short pulses at rest. Errors: Usage.
Result<void> checkPlatenCalibrate(const devices::Catalogue& catalogue, const CalibrateConfig& config);

CalibratePrediction predictPlatenCalibrate(const CalibrateConfig& config, double start_degC);

/// The chosen calibrations from one fit; figures "chip1.amplitude" ... in SI with intervals, and the periodic
/// error of the poses over a cell before and after ("error_x_before", m, peak to peak). Restores the board;
/// with `apply` the values are written in one transaction and read back. Errors: as runCalibrate().
Result<CalibrateResult> calibratePlaten(devices::Device& device, const CalibrateConfig& config,
                                        const ProcedureObserver& observer);

} // namespace halbench::app
