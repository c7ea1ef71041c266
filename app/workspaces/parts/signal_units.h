#pragma once

#include "app/workbench/display_quantity.h"
#include "widgets/live_plot/live_plot_spec.h"

#include <string>
#include <vector>

namespace halbench::app {

/// The units that a signal of this SI unit can be shown in, first the one of the preferences, whose key is
/// empty. None where there is nothing to choose.
std::vector<widgets::UnitChoice> unitChoices(const std::string& symbol, const DisplayUnits& units);

/// Whether any signal can be shown in the unit with this name in files.
bool isDisplayUnit(const std::string& key);
/// All of them, with commas.
std::string displayUnitNames();

} // namespace halbench::app
