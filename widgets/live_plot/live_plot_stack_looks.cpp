// Colours, lines and names that the user chose for the signals of a stack of plots.
#include "widgets/live_plot/live_legend.h"
#include "widgets/live_plot/live_plot.h"
#include "widgets/live_plot/live_plot_stack.h"

#include <string>
#include <utility>
#include <vector>

namespace halbench::widgets {
namespace {

bool hasPlace(const CurveLooks& looks, const std::string& signal) {
    const auto found = looks.find(signal);
    return found != looks.end() && found->second.place.has_value();
}

/// Signals whose colour is automatic again are as if they left: what was chosen is not kept for them.
std::vector<PlotSpec> withoutReleased(std::vector<PlotSpec> plots, const CurveLooks& before,
                                      const CurveLooks& now) {
    for (PlotSpec& plot : plots) {
        std::erase_if(plot.curves, [&](const PlotCurve& curve) {
            return hasPlace(before, curve.signal) && !hasPlace(now, curve.signal);
        });
    }
    return plots;
}

} // namespace

void LivePlotStack::connectLooks(LivePlot* plot, LiveLegend* legend) {
    const auto change = [this, plot](int curve, const auto& edit) {
        const std::string signal = plot->spec().curves[static_cast<std::size_t>(curve)].signal;
        CurveLooks looks = m_looks;
        edit(looks[signal], m_colours.placeOf(signal, curve));
        setLooks(std::move(looks));
        Q_EMIT plotsChanged();
    };
    connect(legend, &LiveLegend::colourRequested, this, [change](int curve, std::optional<int> colour) {
        change(curve, [&](CurveLook& look, int place) {
            look.place = colour ? std::optional(placeWith(*colour, patternAt(place))) : std::nullopt;
        });
    });
    connect(legend, &LiveLegend::lineRequested, this, [change](int curve, LinePattern pattern) {
        change(curve, [&](CurveLook& look, int place) { look.place = placeWith(place, pattern); });
    });
    connect(&legend->table(), &LegendTableModel::renamed, this, [change](int curve, const QString& name) {
        change(curve, [&](CurveLook& look, int) { look.name = name; });
    });
}

void LivePlotStack::setLooks(CurveLooks looks) {
    std::erase_if(looks, [](const auto& entry) { return entry.second == CurveLook{}; });
    const CurveLooks before = std::exchange(m_looks, std::move(looks));
    nameCurves();
    m_colours.update(withoutReleased(m_specs, before, m_looks), m_looks);
    m_colours.update(m_specs, m_looks);
    for (const Row& row : m_rows) {
        row.plot->setLooks(m_colours, m_looks);
        row.legend->setTheme(m_theme);
    }
    m_isDirty = true;
}

/// Also of those that were just added.
void LivePlotStack::nameCurves() {
    for (PlotSpec& spec : m_specs) {
        for (PlotCurve& curve : spec.curves) {
            const auto look = m_looks.find(curve.signal);
            curve.ownName = look == m_looks.end() ? QString() : look->second.name;
        }
    }
}

} // namespace halbench::widgets
