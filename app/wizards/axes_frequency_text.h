#pragma once

#include "app/procedures/frequency/axes_frequency.h"
#include "widgets/controls/estimate_table.h"

#include <QString>

#include <vector>

namespace halbench::app {

/// Motion, currents and time of a measurement of this length, before anything moves.
QString axesFrequencyOutlook(const AxesFrequencyConfig& config, double duration_s,
                             const std::vector<devices::AxisSpec>& axes);

/// Phase and gain margin of every loop while the others are closed, then the peaks of all loops together.
std::vector<widgets::EstimateRow> axesFrequencyRows(const AxesFrequencyResult& result);

/// How many frequencies count, and the strongest coupling between two axes.
QString axesFrequencyUse(const AxesFrequencyResult& result);

} // namespace halbench::app
