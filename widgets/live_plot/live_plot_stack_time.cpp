// The time axes of a stack of plots: the one that its plots share and those of single plots.
#include "widgets/live_plot/axes/time_axis_bar.h"
#include "widgets/live_plot/live_legend.h"
#include "widgets/live_plot/live_plot.h"
#include "widgets/live_plot/live_plot_stack.h"

#include <QAction>

#include <algorithm>
#include <utility>

namespace halbench::widgets {
namespace {

constexpr std::size_t ZoomHistoryLength = 50;
constexpr double KeyZoom = 1.5;
constexpr double Page_ratio = 0.9; ///< of the view

} // namespace

const TimeView& LivePlotStack::viewOf(int plot) const {
    const std::optional<TimeView>& own = m_rows.at(static_cast<std::size_t>(plot)).time;
    return own ? *own : m_view;
}

/// The plot whose time axis keys act on: the focused one; without focus any that shares the stack's axis.
int LivePlotStack::axisPlot() const {
    const auto shares = std::find_if(m_rows.begin(), m_rows.end(), [](const Row& row) { return !row.time; });
    const auto sharing = static_cast<int>(shares == m_rows.end() ? 0 : shares - m_rows.begin());
    return focusedPlot().value_or(sharing);
}

TimeView& LivePlotStack::activeView() {
    return viewOf(axisPlot());
}

const TimeView& LivePlotStack::activeView() const {
    return viewOf(axisPlot());
}

std::vector<int> LivePlotStack::plotsOfActiveAxis() const {
    const TimeView* active = &activeView();
    std::vector<int> list;
    for (int i = 0; i < static_cast<int>(m_rows.size()); ++i) {
        if (&viewOf(i) == active) {
            list.push_back(i);
        }
    }
    return list;
}

bool LivePlotStack::hasOwnTimes() const {
    return std::any_of(m_rows.begin(), m_rows.end(), [](const Row& row) { return row.time.has_value(); });
}

std::optional<OwnTime> LivePlotStack::ownTime(int plot) const {
    const std::optional<TimeView>& own = m_rows.at(static_cast<std::size_t>(plot)).time;
    return own ? std::optional(OwnTime{own->range().length_s(), own->isFollowing()}) : std::nullopt;
}

void LivePlotStack::setOwnTime(int plot, const std::optional<OwnTime>& own) {
    const auto index = static_cast<std::size_t>(plot);
    m_specs.at(index).ownTime = own;
    m_rows.at(index).time.reset();
    matchTime(index);
    m_zoomHistory.clear(); // its entries belong to the axes as they were
    changed(isFollowing(), isPaused());
}

/// A row has an axis of its own when its plot's description says so; what the user did to it since stays.
void LivePlotStack::matchTime(std::size_t index) {
    Row& row = m_rows[index];
    const std::optional<OwnTime>& own = m_specs[index].ownTime;
    if (own && !row.time) {
        row.time = m_view;
        row.time->zoom(own->span_s / m_view.range().length_s(), m_view.range().end_s);
        if (!isPaused()) {
            row.time->setFollowing(own->isFollowing);
        }
    } else if (!own) {
        row.time.reset();
    }
    row.timeAxis->setVisible(own.has_value());
    row.timeAxis->setAccessibleName(tr("Time axis of %1").arg(m_specs[index].quantity));
    const int column = m_specs[index].column;
    const std::vector<const Row*> rows = rowsOf(column);
    m_columns[static_cast<std::size_t>(column)].timeAxis->setVisible(
        std::any_of(rows.begin(), rows.end(), [](const Row* each) { return !each->time; }));
}

/// It begins where the plot stands.
void LivePlotStack::toggleOwnTime(int plot) {
    const TimeView& view = viewOf(plot);
    setOwnTime(plot, ownTime(plot) ? std::nullopt
                                   : std::optional(OwnTime{view.range().length_s(), view.isFollowing()}));
    Q_EMIT plotsChanged();
}

void LivePlotStack::shareTime() {
    for (int i = 0; i < static_cast<int>(m_rows.size()); ++i) {
        setOwnTime(i, std::nullopt);
    }
    Q_EMIT plotsChanged();
}

void LivePlotStack::createTimeActions() {
    addAction(Command::OwnTime, tr("Own time axis"), QStringLiteral("O"),
              tr("Zoom and scroll this plot separately; again: with the others"));
    addAction(Command::OneTimeAxis, tr("One time axis for all plots"), QStringLiteral("Shift+O"),
              tr("Use the common time axis in all plots"));
    m_actions.at(Command::OwnTime)->setCheckable(true);
}

/// On the time axis of the plot that has the focus.
void LivePlotStack::runOnTime(Command command) {
    const bool wasFollowing = isFollowing();
    const bool wasPaused = isPaused();
    TimeView& view = activeView();
    const double middle_s = 0.5 * (view.range().begin_s + view.range().end_s);
    switch (command) {
    case Command::Follow: {
        const bool follows = wasPaused || !view.isFollowing();
        setPaused(false);
        view.setFollowing(follows);
        break;
    }
    case Command::ShowAll:
        remember();
        view.showAll();
        break;
    case Command::ZoomIn:
    case Command::ZoomOut:
        return zoomTime(view, command == Command::ZoomIn ? 1.0 / KeyZoom : KeyZoom, middle_s);
    case Command::ScrollBack:
    case Command::ScrollOn:
        view.pan((command == Command::ScrollOn ? Page_ratio : -Page_ratio) * view.range().length_s());
        break;
    case Command::OwnTime:
        return toggleOwnTime(axisPlot());
    default:
        return shareTime();
    }
    changed(wasFollowing, wasPaused);
}

void LivePlotStack::changed(bool wasFollowing, bool wasPaused) {
    m_isDirty = true;
    showChecks();
    if (wasFollowing != isFollowing()) {
        Q_EMIT followingChanged(isFollowing());
    }
    if (wasPaused != isPaused()) {
        Q_EMIT pausedChanged(isPaused());
    }
}

void LivePlotStack::setFollowing(bool isFollowing) {
    const bool wasFollowing = this->isFollowing();
    const bool wasPaused = isPaused();
    if (isFollowing) {
        setPaused(false);
    }
    m_view.setFollowing(isFollowing);
    changed(wasFollowing, wasPaused);
}

void LivePlotStack::setPaused(bool isPaused) {
    const bool wasFollowing = isFollowing();
    const bool wasPaused = this->isPaused();
    m_view.setPaused(isPaused);
    for (Row& row : m_rows) {
        if (row.time) {
            row.time->setPaused(isPaused);
        }
    }
    changed(wasFollowing, wasPaused);
}

void LivePlotStack::setTimeSpan(double length_s) {
    if (length_s > 0.0) {
        m_view.zoom(length_s / m_view.range().length_s(), m_view.range().end_s);
        m_isDirty = true;
    }
}

void LivePlotStack::showTimeRange(control::TimeRange range) {
    const bool wasFollowing = isFollowing();
    m_view.show(range);
    changed(wasFollowing, isPaused());
}

void LivePlotStack::remember() {
    Snapshot snapshot{m_view, {}, {}};
    for (const Row& row : m_rows) {
        const HeldRanges held = row.plot->heldRanges();
        snapshot.values.emplace_back(held.left, held.right);
        snapshot.ownTimes.push_back(row.time);
    }
    m_zoomHistory.push_back(std::move(snapshot));
    if (m_zoomHistory.size() > ZoomHistoryLength) {
        m_zoomHistory.erase(m_zoomHistory.begin());
    }
    m_isWheeling = false;
}

void LivePlotStack::zoomBack() {
    if (m_zoomHistory.empty()) {
        return;
    }
    const bool wasFollowing = isFollowing();
    const bool wasPaused = isPaused();
    m_view = m_zoomHistory.back().view;
    for (std::size_t i = 0; i < m_rows.size() && i < m_zoomHistory.back().values.size(); ++i) {
        const auto& [left, right] = m_zoomHistory.back().values[i];
        m_rows[i].plot->setHeldRanges({left, right});
        m_rows[i].time = m_zoomHistory.back().ownTimes[i];
    }
    m_zoomHistory.pop_back();
    m_isWheeling = false;
    changed(wasFollowing, wasPaused);
}

void LivePlotStack::zoomTime(TimeView& view, double factor, double at_s) {
    if (!m_isWheeling) {
        remember();
        m_isWheeling = true;
    }
    view.zoom(factor, at_s);
    m_isDirty = true;
}

/// Plots on the time axis that keys act on.
void LivePlotStack::fitAll() {
    remember();
    const bool wasFollowing = isFollowing();
    if (TimeView& view = activeView(); !view.isFollowing()) {
        view.showAll();
    }
    const std::vector<int> fitted = plotsOfActiveAxis();
    for (const int plot : fitted) {
        m_rows[static_cast<std::size_t>(plot)].plot->setHeldRanges({});
    }
    m_drawnRevision.reset();
    drawFrame();
    for (const int plot : fitted) {
        m_rows[static_cast<std::size_t>(plot)].plot->fitValues();
    }
    changed(wasFollowing, isPaused());
}

/// Buttons and menus say how the time axis is that they act on.
void LivePlotStack::showChecks() {
    m_actions.at(Command::Follow)->setChecked(activeView().isFollowing());
    m_actions.at(Command::Pause)->setChecked(isPaused());
    m_actions.at(Command::OwnTime)->setChecked(ownTime(axisPlot()).has_value());
    m_actions.at(Command::OneTimeAxis)->setEnabled(hasOwnTimes());
}

} // namespace halbench::widgets
