#pragma once

#include "app/procedures/identify/axes_identification.h"
#include "devices/device.h"
#include "widgets/controls/estimate_table.h"

#include <QString>

#include <vector>

namespace halbench::app {

/// Damping, gain and friction of each axis, then ratios and constants of the actuator, with their intervals.
std::vector<widgets::EstimateRow> axesRows(const AxesIdentifyResult& result,
                                           const std::vector<devices::AxisSpec>& axes);

/// Motion of the axes in an identification, before it begins.
QString axesOutlook(const IdentifyPrediction& prediction, const std::vector<devices::AxisSpec>& axes);

} // namespace halbench::app
