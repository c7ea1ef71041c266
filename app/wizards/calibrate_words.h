#pragma once

#include "app/batch/result_header.h"
#include "app/procedures/calibrate_procedure.h"
#include "widgets/estimate_table.h"

#include <QString>

#include <vector>

namespace halbench::app {

/// What each calibration does to the rotor, before anything moves.
QString calibrationOutlook(const CalibrateConfig& config);

/// What was found, with the value on the device beside it where the figure is a parameter. T and rad are
/// shown as mT and degrees.
std::vector<widgets::EstimateRow> calibrationRows(const CalibrateResult& result);

/// Angle error before and after; empty where the sensors were not calibrated.
QString calibrationGain(const CalibrateResult& result);

/// That it came with the project: when it was measured, and on which device.
QString projectCalibrationText(const ResultHeader& header);

} // namespace halbench::app
