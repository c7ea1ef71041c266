#pragma once

#include "app/documents/result_header.h"
#include "app/procedures/calibrate/calibrate_procedure.h"
#include "app/workbench/display_quantity.h"
#include "widgets/controls/estimate_table.h"

#include <QString>

#include <map>
#include <string>
#include <vector>

namespace halbench::app {

/// Motion of the rotor in each calibration, before anything moves.
QString calibrationOutlook(const CalibrateConfig& config, const DisplayUnits& units);

/// The same for a device whose rotor is moved by hand.
QString handMotionOutlook(const CalibrateConfig& config);
/// Orientations that a motion made by hand lacks so far: `missing`, most wanted first, by angles in `order`.
QString handMotionNeeds(bool isEnough, const std::vector<std::string>& missing, const std::string& order);
/// The same of a device with several axes.
QString axesCalibrationOutlook(const CalibratePrediction& prediction);

/// What was found, with the value that the device has now beside it where the figure is a parameter; without
/// a device the one that it had. T is shown as mT, an angle as the
/// user prefers.
std::vector<widgets::EstimateRow> calibrationRows(const CalibrateResult& result,
                                                  const std::map<std::string, double>* deviceValues,
                                                  const DisplayUnits& units);

/// Residual angle error before and after, and what that is; empty where the sensors were not calibrated.
QString calibrationGain(const CalibrateResult& result, const DisplayUnits& units);

/// That the static breakaway current is not Identify's K_f/phi, with a link to the help; empty without it.
QString breakawayNote(const CalibrateResult& result);

/// That it came with the project: when it was measured, and on which device.
QString projectCalibrationText(const ResultHeader& header);
/// That it was measured before the device was connected again, and on which device.
QString earlierCalibrationText(const ResultHeader& header);

} // namespace halbench::app
