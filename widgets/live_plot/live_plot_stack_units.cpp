// Units of single curves of a stack of plots, chosen in its legends.
#include "widgets/live_plot/curve_units.h"
#include "widgets/live_plot/live_legend.h"
#include "widgets/live_plot/live_plot.h"
#include "widgets/live_plot/live_plot_stack.h"

#include <algorithm>
#include <utility>

namespace halbench::widgets {

void LivePlotStack::connectUnits(LivePlot* plot, LiveLegend* legend) {
    connect(legend, &LiveLegend::unitRequested, this, [this, plot](int curve, const std::string& unit) {
        const int index = indexOf(plot);
        const std::vector<PlotCurve>& curves = m_specs[static_cast<std::size_t>(index)].curves;
        const std::string signal = curves[static_cast<std::size_t>(curve)].signal;
        const std::size_t count = m_specs.size();
        if (showInUnit(index, signal, unit)) {
            choose(m_specs.size() > count ? index + 1 : index, signal);
            Q_EMIT plotsChanged();
        }
    });
}

bool LivePlotStack::showInUnit(int plot, const std::string& signal, const std::string& unit) {
    if (plot < 0 || plot >= static_cast<int>(m_specs.size())) {
        return false;
    }
    PlotSpec changed = m_specs[static_cast<std::size_t>(plot)];
    changed.fixedRange = heldRange(plot); // the other axis stays as the user holds it
    changed.right.fixedRange = heldRange(plot, true);
    UnitChange change = showIn(changed, signal, unit);
    if (!change.isChanged) {
        return false;
    }
    m_specs[static_cast<std::size_t>(plot)] = std::move(changed);
    m_zoomHistory.clear(); // its entries belong to the axes as they were
    if (change.below) {
        openPlot(plot + 1, *std::move(change.below));
    } else {
        matchRows();
    }
    return true;
}

} // namespace halbench::widgets
