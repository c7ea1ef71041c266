#pragma once

#include "app/procedures/frequency/frequency_plan.h"
#include "devices/device.h"
#include "widgets/controls/estimate_table.h"

#include <QString>

#include <map>
#include <string>
#include <vector>

namespace halbench::app {

/// Texts of the window about a frequency response; pure functions of values.

/// The loop that would be measured, from what is known of the device; without one the published motor's.
FrequencyMargins frequencyOutlookMargins(const devices::Catalogue& catalogue,
                                         const std::map<std::string, double>& deviceValues);

/// What will move and how far, how long, how warm.
QString frequencyOutlook(const FrequencyConfig& config, const FrequencyPlan& plan, double warmest_degC);

/// A margin with its interval, or why it is withheld.
widgets::EstimateRow marginRow(const QString& name, const control::MeasuredMargin& margin,
                               const QString& unit);

/// Margins, told or withheld with the reason, then the rotor that fits.
std::vector<widgets::EstimateRow> frequencyRows(const FrequencyResult& result);

/// How many points are used, and how strongly each band was excited.
QString frequencyUse(const FrequencyResult& result);

} // namespace halbench::app
