#pragma once

#include "app/documents/model_file.h"
#include "app/procedures/calibrate/calibrate_procedure.h"
#include "app/procedures/tune/analyse.h"
#include "devices/device.h"

#include <map>
#include <optional>
#include <string>
#include <utility>

namespace halbench::app {

/// The surroundings of the loop from the shipped profile of a model (period, current limit, stray field);
/// defaults for a model without one. Errors: of the profile.
Result<LoopConditions> loopConditionsOf(const std::string& model);

/// The same with the timing that the model was measured with, where its file says it. Errors: likewise.
Result<LoopConditions> loopConditionsOf(const ModelFile& model);

/// The same from what a device says of itself: its delay, its current limit, its stray-field compensation. Of
/// a parameter that is not among the values, what the catalogue knows.
LoopConditions loopConditionsOf(const devices::Catalogue& catalogue,
                                const std::map<std::string, double>& values);
/// From values that are read now. Errors: of the device.
Result<LoopConditions> loopConditionsOf(devices::Device& device);

/// 95 % interval of k_s in T/A, when the calibration found it.
std::optional<std::pair<double, double>> strayInterval(const CalibrateResult& calibration);
/// The doubts that it casts on loops which are judged with it.
std::vector<Finding> calibrationDoubts(const CalibrateResult& calibration);

/// Sets the error of the coefficient that the board compensates with: its distance from the far end of the
/// interval, so that a calibration that was not applied counts too (resources/help/htm-theory.md 8.4).
/// Nothing changes without an interval or for a device without stray field.
void takeStrayInterval(LoopConditions& conditions,
                       const std::optional<std::pair<double, double>>& interval95_T_per_A);

/// The same from a calibration's file; an applied one is what the board compensates with. Nothing changes
/// without a path. Errors: of the file; Refused when it holds no stray coefficient.
Result<void> takeCalibration(LoopConditions& conditions, const std::string& path);

} // namespace halbench::app
