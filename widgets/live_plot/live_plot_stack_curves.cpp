// Curves of a stack of plots: what its legends ask for, on which axis of which plot they are, and how they
// look.
#include "widgets/live_plot/live_legend.h"
#include "widgets/live_plot/live_plot.h"
#include "widgets/live_plot/live_plot_stack.h"

#include <QAction>

#include <algorithm>
#include <set>
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

void LivePlotStack::connectLegend(LivePlot* plot, LiveLegend* legend) {
    const auto signalAt = [this, plot](int curve) { // a copy: what is asked for may end it
        return m_specs[static_cast<std::size_t>(indexOf(plot))]
            .curves[static_cast<std::size_t>(curve)]
            .signal;
    };
    connect(legend, &LiveLegend::removeRequested, this, [this, plot, signalAt](int curve) {
        removeCurve(indexOf(plot), signalAt(curve));
        Q_EMIT plotsChanged();
    });
    connect(legend, &LiveLegend::axisRequested, this, [this, plot, signalAt](int curve) {
        const std::string signal = signalAt(curve);
        const int index = indexOf(plot);
        const bool isRight = plot->spec().curves[static_cast<std::size_t>(curve)].isRight;
        if (moveToAxis(index, signal, !isRight)) {
            choose(index, signal);
            Q_EMIT plotsChanged();
        }
    });
    connect(legend, &LiveLegend::moveRequested, this, [this, plot, signalAt](int curve, int by) {
        const int index = indexOf(plot);
        const int to = index + by;
        const bool isThere =
            to >= 0 && to < static_cast<int>(m_specs.size()) &&
            m_specs[static_cast<std::size_t>(to)].column == m_specs[static_cast<std::size_t>(index)].column;
        moveAndChoose(index, signalAt(curve), isThere ? std::optional(to) : std::nullopt);
    });
    connect(legend, &LiveLegend::moveBesideRequested, this, [this, plot, signalAt](int curve, int by) {
        moveAndChoose(indexOf(plot), signalAt(curve), plotBeside(indexOf(plot), by));
    });
    connect(legend, &LiveLegend::separateRequested, this, [this, plot, signalAt](int curve) {
        const std::string signal = signalAt(curve);
        const int index = indexOf(plot);
        if (separateCurve(index, signal)) {
            choose(index + 1, signal);
            Q_EMIT plotsChanged();
        }
    });
    connect(legend, &LiveLegend::separateBesideRequested, this, [this, plot, signalAt](int curve) {
        const std::string signal = signalAt(curve);
        const int column = m_specs[static_cast<std::size_t>(indexOf(plot))].column + 1;
        if (separateBeside(indexOf(plot), signal)) {
            const auto own = std::find_if(m_specs.begin(), m_specs.end(),
                                          [column](const PlotSpec& spec) { return spec.column == column; });
            choose(static_cast<int>(own - m_specs.begin()), signal);
            Q_EMIT plotsChanged();
        }
    });
    connectUnits(plot, legend);
    connectLooks(plot, legend);
    connect(legend, &LiveLegend::toggleRequested, this, [this, plot, legend](int curve) {
        HistoryCurve* item = plot->curves()[static_cast<std::size_t>(curve)];
        item->setVisible(!item->isVisible());
        legend->setTheme(m_theme);
        m_isDirty = true;
    });
}

/// Where it went may have another place by then: its old plot goes when it had nothing else.
void LivePlotStack::moveAndChoose(int plot, const std::string& signal, std::optional<int> to) {
    if (!to) {
        return;
    }
    const LivePlot* target = m_rows[static_cast<std::size_t>(*to)].plot;
    if (moveCurve(plot, signal, *to)) {
        choose(indexOf(target), signal);
        Q_EMIT plotsChanged();
    }
}

/// The curve that was moved stays the chosen one, so that keys go on with it.
void LivePlotStack::choose(int plot, const std::string& signal) {
    const std::vector<PlotCurve>& curves = m_specs[static_cast<std::size_t>(plot)].curves;
    const auto found = std::find_if(curves.begin(), curves.end(),
                                    [&](const PlotCurve& curve) { return curve.signal == signal; });
    LiveLegend* legend = m_rows[static_cast<std::size_t>(plot)].legend;
    legend->setCurrentIndex(legend->model()->index(static_cast<int>(found - curves.begin()), 0));
    legend->setFocus();
}

bool LivePlotStack::moveToAxis(int plot, const std::string& signal, bool isRight) {
    if (plot < 0 || plot >= static_cast<int>(m_specs.size()) ||
        !putOnAxis(m_specs[static_cast<std::size_t>(plot)], signal, isRight)) {
        return false;
    }
    m_zoomHistory.clear(); // its entries belong to the axes as they were
    matchRows();
    return true;
}

bool LivePlotStack::moveCurve(int plot, const std::string& signal, int to) {
    const auto count = static_cast<int>(m_specs.size());
    if (plot < 0 || plot >= count || to < 0 || to >= count || to == plot) {
        return false;
    }
    const std::vector<PlotCurve>& curves = m_specs[static_cast<std::size_t>(plot)].curves;
    const auto found = std::find_if(curves.begin(), curves.end(),
                                    [&](const PlotCurve& curve) { return curve.signal == signal; });
    PlotSpec& target = m_specs[static_cast<std::size_t>(to)];
    const auto hasSignal = [&](const PlotCurve& curve) { return curve.signal == signal; };
    if (found == curves.end() || std::any_of(target.curves.begin(), target.curves.end(), hasSignal)) {
        return false;
    }
    PlotCurve moved = *found;
    const bool isRight = !takes(target, false, moved.unit);
    if (isRight && !takes(target, true, moved.unit)) {
        return false;
    }
    const bool isNew = isRight ? !hasRightAxis(target) : target.curves.empty();
    const PlotSpec& source = m_specs[static_cast<std::size_t>(plot)];
    const PlotAxis axis{moved.isRight ? source.right.quantity : source.quantity, moved.unit, {}};
    moved.isRight = isRight;
    if (isNew && isRight) {
        target.right = axis;
    } else if (isNew) {
        target.quantity = axis.quantity;
        target.unit = axis.unit;
    }
    target.curves.push_back(moved);
    removeCurve(plot, signal);
    return true;
}

/// The curve in a plot that has nothing else; nothing where it is alone already.
std::optional<PlotSpec> LivePlotStack::ownPlotOf(int plot, const std::string& signal) const {
    if (plot < 0 || plot >= static_cast<int>(m_specs.size())) {
        return std::nullopt;
    }
    const PlotSpec& source = m_specs[static_cast<std::size_t>(plot)];
    const auto found = std::find_if(source.curves.begin(), source.curves.end(),
                                    [&](const PlotCurve& curve) { return curve.signal == signal; });
    if (found == source.curves.end() || source.curves.size() < 2) {
        return std::nullopt;
    }
    PlotSpec own{source.quantity, source.unit, {*found}, source.bands, {}, {}, {}};
    if (found->isRight) { // bands are of the left axis
        own = {source.right.quantity, source.right.unit, {*found}, {}, {}, {}, {}};
        own.curves.front().isRight = false;
    }
    return own;
}

bool LivePlotStack::separateCurve(int plot, const std::string& signal) {
    std::optional<PlotSpec> own = ownPlotOf(plot, signal);
    if (!own) {
        return false;
    }
    openPlot(plot + 1, *std::move(own));
    removeCurve(plot, signal);
    return true;
}

void LivePlotStack::keepReference() {
    std::set<std::string> shown;
    for (const int plot : plotsOfActiveAxis()) {
        for (const HistoryCurve* curve : m_rows[static_cast<std::size_t>(plot)].plot->curves()) {
            if (curve->isVisible()) {
                shown.insert(curve->curve().signal);
            }
        }
    }
    if (m_history == nullptr) {
        return;
    }
    ReferenceTraces traces = keptTraces(*m_history, shown, activeView().range());
    traces.event_s = m_event_s;
    traces.name = tr("previous curves");
    setReference(std::make_shared<const ReferenceTraces>(std::move(traces)));
}

void LivePlotStack::setReference(ReferencePtr reference) {
    m_reference = std::move(reference);
    for (const Row& row : m_rows) {
        row.plot->setReference(m_reference);
    }
    QAction* remove = m_actions.at(Command::RemoveReference);
    remove->setEnabled(m_reference != nullptr);
    remove->setToolTip(QStringLiteral("%1 (%2)").arg(
        m_reference != nullptr ? tr("Remove the reference: %1").arg(m_reference->name) : remove->statusTip(),
        remove->shortcut().toString(QKeySequence::NativeText)));
    m_isDirty = true;
    Q_EMIT referenceChanged();
}

double LivePlotStack::referenceShift_s() const {
    return m_reference != nullptr ? shiftOf(*m_reference, activeView().range().begin_s, m_event_s) : 0.0;
}

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
