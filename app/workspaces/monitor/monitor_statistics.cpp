#include "app/workspaces/monitor/monitor_statistics.h"

#include "widgets/language/display_units.h"
#include "widgets/live_plot/live_plot_stack.h"
#include "widgets/live_plot/statistics_table.h"
#include "widgets/theme/icons.h"

#include <QAction>
#include <QEvent>

#include <algorithm>

namespace halbench::app {

namespace {

constexpr int Period_ms = 250;
constexpr double PlotsShare = 2.0 / 3.0; ///< of the panel's height, at least

std::optional<double> slopeOf(const control::SampleHistory& history, const widgets::PlotCurve& curve,
                              const widgets::CursorPair& cursors) {
    const auto a = history.valueAt(curve.signal, cursors.a_s);
    const auto b = history.valueAt(curve.signal, cursors.b_s);
    const bool isThere = cursors.isVisible && a && b && a->time_s != b->time_s;
    return isThere ? std::optional(curve.factor * (b->value - a->value) / (b->time_s - a->time_s))
                   : std::nullopt;
}

} // namespace

control::TimeRange stretchInView(const widgets::LivePlotStack& stack, int plot) {
    const widgets::CursorPair cursors = stack.cursors();
    return cursors.isVisible
               ? control::TimeRange{std::min(cursors.a_s, cursors.b_s), std::max(cursors.a_s, cursors.b_s)}
               : stack.timeRange(plot);
}

MonitorStatistics::MonitorStatistics(Workbench& bench, widgets::LivePlotStack& stack, QWidget& panel)
    : QObject(&panel), m_bench(bench), m_stack(stack), m_panel(panel) {
    m_action = new QAction(widgets::themedIcon(QStringLiteral("statistics")), tr("Statistics"), &panel);
    m_action->setCheckable(true);
    m_action->setShortcut(QKeySequence(QStringLiteral("S")));
    m_action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    m_action->setToolTip(
        tr("Minimum, maximum, mean, rms and standard deviation in view or between cursors (S)"));
    panel.addAction(m_action);
    m_table = new widgets::StatisticsTable(&panel);
    m_table->hide();
    connect(m_action, &QAction::toggled, this, [this](bool isShown) {
        m_table->setVisible(isShown);
        refresh();
        fit();
    });
    m_stack.installEventFilter(this);
    connect(&m_stack, &widgets::LivePlotStack::cursorsChanged, this, &MonitorStatistics::refresh);
    connect(&m_timer, &QTimer::timeout, this, &MonitorStatistics::refresh);
    m_timer.start(Period_ms);
}

void MonitorStatistics::refresh() {
    if (!m_table->isVisible()) {
        return;
    }
    const control::SampleHistory& history = *m_stack.history();
    const control::SampleHistory::Glance glance(history);
    std::vector<widgets::StatisticsRow> rows;
    for (int i = 0; i < static_cast<int>(m_stack.plots().size()); ++i) {
        const widgets::PlotSpec& plot = m_stack.plots()[static_cast<std::size_t>(i)];
        const control::TimeRange range = stretchInView(m_stack, i);
        for (const widgets::PlotCurve& curve : plot.curves) {
            const control::SampleStatistics found = history.statistics(curve.signal, range);
            widgets::StatisticsRow row;
            row.name = widgets::nameOf(curve);
            row.unit = curve.unit;
            row.decimals = curve.decimals;
            row.min = curve.factor * found.extremes.min;
            row.max = curve.factor * found.extremes.max;
            row.mean = curve.factor * found.moments.mean();
            row.rms = curve.factor * found.moments.rms();
            row.deviation = curve.factor * found.moments.deviation();
            row.slope = slopeOf(history, curve, m_stack.cursors());
            row.count = found.moments.count();
            row.gaps = found.gaps;
            rows.push_back(row);
        }
    }
    for (widgets::StatisticsRow& row : rows) {
        row.isKnown = glance.isWhole(); // a number is right or absent
    }
    m_table->setStretch(glance.isWhole() ? stretchWords() : tr("Reading the disk"));
    m_table->setRows(rows);
    fit(); // whole rows, also beside a scroll bar that came with wider numbers
}

QString MonitorStatistics::stretchWords() const {
    const QString length = widgets::numberText(stretchInView(m_stack, 0).length_s(), 5);
    if (m_stack.cursors().isVisible) {
        return tr("A to B, %1 s").arg(length);
    }
    return m_stack.hasOwnTimes() ? tr("Visible range of each plot") : tr("In view, %1 s").arg(length);
}

QWidget& MonitorStatistics::table() {
    return *m_table;
}

bool MonitorStatistics::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize) {
        fit();
    }
    return QObject::eventFilter(watched, event);
}

/// What is left of the panel when the plots have their share and the tools and bars above them theirs.
void MonitorStatistics::fit() {
    const int above_px = m_stack.mapTo(&m_panel, QPoint()).y();
    const int room_px = static_cast<int>((1.0 - PlotsShare) * m_panel.height()) - above_px;
    m_table->setMaximumHeight(std::max(m_table->heightWithin(room_px), m_table->minimumSizeHint().height()));
}

} // namespace halbench::app
