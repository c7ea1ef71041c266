// What the Monitor shows, taken from a project and given to it.
#include "app/workspaces/monitor/monitor_panel.h"
#include "app/workspaces/monitor/monitor_plots.h"
#include "app/workspaces/monitor/monitor_rate.h"
#include "app/workspaces/monitor/monitor_trigger.h"
#include "widgets/controls/message_bar.h"
#include "widgets/live_plot/live_plot_stack.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::app {

namespace {

constexpr double DefaultSpan_s = 10.0;

/// To milliseconds, a short one to microseconds: the view moves by whole pixel columns, a project shall not.
/// Never to nothing: a project without a length is no project.
double rounded(double time_s) {
    constexpr double Short_s = 0.1;
    const double grains_Hz = time_s < Short_s ? 1e6 : 1e3;
    return std::max(1.0, std::round(time_s * grains_Hz)) / grains_Hz;
}

/// Without its column, which depends on those that are kept.
PlotChoice choiceOf(const widgets::LivePlotStack& stack, int index) {
    const widgets::PlotSpec& plot = stack.plots()[static_cast<std::size_t>(index)];
    PlotChoice choice;
    for (const widgets::PlotCurve& curve : plot.curves) {
        (curve.isRight ? choice.rightNames : choice.signalNames).push_back(curve.signal);
        if (!curve.ownUnit.empty()) {
            choice.units[curve.signal] = curve.ownUnit;
        }
    }
    choice.range = stack.heldRange(index);
    choice.unit = choice.range ? plot.unit.toStdString() : std::string();
    if (!choice.rightNames.empty()) {
        choice.rightRange = stack.heldRange(index, true);
        choice.rightUnit = choice.rightRange ? plot.right.unit.toStdString() : std::string();
    }
    choice.height_ratio = plot.height_ratio;
    choice.ownTime = stack.ownTime(index);
    if (choice.ownTime) {
        choice.ownTime->span_s = rounded(choice.ownTime->span_s);
    }
    return choice;
}

/// What of a project is not shown as it says.
widgets::Message notAsKept(const QStringList& missing, const QStringList& unfit) {
    QStringList texts;
    QStringList remedies;
    if (!missing.isEmpty()) {
        texts << MonitorPanel::tr("Signals of the project that this device does not have: %1")
                     .arg(missing.join(", "));
        remedies << MonitorPanel::tr(
            "They are not plotted. The project keeps them until you change the plots.");
    }
    if (!unfit.isEmpty()) {
        texts
            << MonitorPanel::tr("Units of the project that do not fit the signals: %1").arg(unfit.join(", "));
        remedies << MonitorPanel::tr("The units of the preferences are used. Choose others in the legend "
                                     "(U). The project keeps its entries until you change the plots.");
    }
    return {
        widgets::Severity::Warning, texts.join(QStringLiteral("; ")), remedies.join(QLatin1Char(' ')), {}};
}

} // namespace

void MonitorPanel::showView() {
    const devices::Catalogue& catalogue = m_bench.catalogue();
    const TemperatureBands bands = temperatureBands(catalogue, m_bench.deviceValue("limit.temperature"));
    QStringList missing;
    auto plots = chosenPlots(m_view.plots, catalogue, bands, m_bench.displayUnits(), missing);
    m_stack->setPlots(plots.empty() && isFirst() ? defaultPlots(catalogue, bands, m_bench.displayUnits())
                                                 : std::move(plots));
    m_stack->setLooks(m_view.looks);
    m_stack->setTimeSpan(m_view.span_s.value_or(DefaultSpan_s));
    m_stack->setFollowing(m_view.isFollowing);
    for (int i = 0; i < static_cast<int>(m_stack->plots().size()); ++i) {
        m_stack->setOwnTime(i, m_stack->plots()[static_cast<std::size_t>(i)].ownTime);
    }
    const QStringList unfit = unfitUnits(m_view.plots, catalogue);
    m_isIncomplete = !missing.isEmpty() || !unfit.isEmpty();
    m_message->clear();
    if (m_isIncomplete) {
        m_message->showMessage(notAsKept(missing, unfit));
    }
}

void MonitorPanel::setView(const MonitorView& view) {
    m_view = view;
    if (isFirst()) {
        m_bench.setDerivedSignals(view.derived);
        m_rate->setRate_Hz(view.rate_Hz);
        m_trigger->setChoice(view.trigger);
        m_trigger->setLivePairs(cursorPairs(view));
    }
    m_message->clear();
    m_isIncomplete = false;
    if (m_bench.session().state() == SessionState::Connected && !m_device.isEmpty()) {
        showView();
        onPlotsChanged();
    } else {
        m_device.clear();
    }
}

MonitorView MonitorPanel::view() const {
    MonitorView view = m_device.isEmpty() ? m_view : MonitorView{};
    if (isFirst()) {
        view.derived = m_bench.derivedSignals();
        view.rate_Hz = m_rate->rate_Hz();
        keepCursors(m_trigger->livePairs(), view);
    }
    if (m_device.isEmpty()) {
        return view;
    }
    view.isFollowing = m_stack->isFollowing();
    view.looks = m_stack->looks();
    if (isFirst()) {
        view.trigger = m_trigger->choice();
        view.isFollowing = m_trigger->isOn() ? m_trigger->isFollowingOtherwise() : view.isFollowing;
    }
    view.span_s =
        m_stack->isFollowing() ? std::optional(rounded(m_stack->timeRange().length_s())) : m_view.span_s;
    if (m_isIncomplete) {
        view.plots = m_view.plots;
        return view;
    }
    const std::vector<widgets::PlotSpec>& plots = m_stack->plots();
    std::optional<int> column;
    for (std::size_t i = 0; i < plots.size(); ++i) {
        PlotChoice choice = choiceOf(*m_stack, static_cast<int>(i));
        if (choice.signalNames.empty()) {
            continue;
        }
        if (!column || plots[i].column != *column) { // one with empty plots alone is not kept
            choice.column = column ? view.plots.back().column + 1 : 0;
            choice.width_ratio = plots[i].width_ratio;
            column = plots[i].column;
        } else {
            choice.column = view.plots.back().column;
        }
        view.plots.push_back(std::move(choice));
    }
    return view;
}

} // namespace halbench::app
