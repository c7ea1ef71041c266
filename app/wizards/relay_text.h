#pragma once

#include "app/procedures/relay/relay_procedure.h"
#include "widgets/controls/estimate_table.h"

#include <QString>

#include <vector>

namespace halbench::app {

/// Texts of the window about a relay experiment; pure functions of values.

/// Travel, time and temperature of the experiment, before it begins.
QString relayOutlook(const RelayConfig& config, const RelayPlan& plan, double warmest_degC);

/// Ultimate gain and period with their intervals, the phase that was measured, and the model's own.
std::vector<widgets::EstimateRow> relayRows(const RelayResult& result);

/// Whether the model agrees, and how the loop swung.
QString relayUse(const RelayResult& result);

} // namespace halbench::app
