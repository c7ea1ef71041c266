#pragma once

#include "widgets/live_plot/live_plot_spec.h"

#include <optional>
#include <vector>

namespace halbench::widgets {

/// The choice with this key; null: the curve has none.
const UnitChoice* findChoice(const PlotCurve& curve, const std::string& key);

// An axis shows one unit. A curve in another one than the others of its axis goes to the opposite axis if
// that shows the same unit or is free, else into a plot of its own below.

/// What the choice of a unit does to a plot.
struct UnitChange {
    bool isChanged = false;
    std::optional<PlotSpec> below = {}; ///< the curve's own plot, where neither axis took it
};

/// Shows a curve in one of its units. The axis goes along where the curve is alone on it; alone on the right
/// in the unit and quantity of the left axis it joins that.
UnitChange showIn(PlotSpec& plot, const std::string& signal, const std::string& unit);

/// After units became others: each axis shows the unit of its first curve, and is held no more if that is a
/// new one. Returns the plots for below, one for each unit that had no place.
std::vector<PlotSpec> settleUnits(PlotSpec& plot);
/// The same in a whole list.
void settleUnits(std::vector<PlotSpec>& plots);

} // namespace halbench::widgets
