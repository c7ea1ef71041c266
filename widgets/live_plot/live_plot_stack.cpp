#include "widgets/live_plot/live_plot_stack.h"

#include "widgets/controls/share_splitter.h"
#include "widgets/live_plot/axes/time_axis_bar.h"
#include "widgets/live_plot/cursor_bar.h"
#include "widgets/live_plot/live_legend.h"
#include "widgets/live_plot/live_plot.h"
#include "widgets/live_plot/marker_bar.h"
#include "widgets/theme/theme_style.h"

#include <QAction>
#include <QHBoxLayout>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace halbench::widgets {
namespace {

constexpr int FramePeriod_ms = 33; ///< 30 frames a second
constexpr int HandleWidth = 4;

} // namespace

LivePlotStack::LivePlotStack(QWidget* parent)
    : QWidget(parent), m_splitter(new ShareSplitter(Qt::Horizontal, this)), m_cursorBar(new CursorBar(this)),
      m_markerBar(new MarkerBar(this)), m_timer(new QTimer(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_splitter, 1);
    layout->addWidget(m_cursorBar);
    layout->addWidget(m_markerBar);
    m_splitter->setHandleWidth(HandleWidth);
    m_splitter->setProperty("surface", QStringLiteral("plots"));
    connect(m_splitter, &ShareSplitter::sharesChanged, this,
            [this] { setWidths(m_specs, m_splitter->shares()); });
    m_cursorBar->hide();
    createActions();
    connectCursorBar();
    connectMarkerBar();
    connect(m_timer, &QTimer::timeout, this, &LivePlotStack::refresh);
    setTheme(currentTheme());
    setPlots({});
    m_timer->start(FramePeriod_ms);
}

LivePlotStack::~LivePlotStack() = default;

void LivePlotStack::setStale(const QString& words) {
    m_stale = words;
    m_isDirty = true;
}

void LivePlotStack::setLive(bool isLive) {
    m_isLive = isLive;
    for (const Command command : {Command::Follow, Command::Pause}) {
        m_actions.at(command)->setEnabled(isLive);
    }
    m_isDirty = true;
}

void LivePlotStack::setHistory(const control::SampleHistory* history) {
    for (Row& row : m_rows) {
        if (row.time && history != m_history) {
            row.time->setFollowing(true); // where it stood is no place of the other one
        }
    }
    m_history = history;
    m_drawnRevision.reset();
    matchRows();
}

void LivePlotStack::setPlots(std::vector<PlotSpec> plots) {
    m_specs = std::move(plots);
    if (m_specs.empty()) {
        m_specs.emplace_back();
    }
    settleColumns(m_specs);
    for (Column& column : m_columns) {
        column.extent_px = 0;
        column.rightExtent_px = 0;
    }
    m_zoomHistory.clear();
    matchRows();
}

void LivePlotStack::addCurve(int plot, const PlotCurve& curve) {
    const bool isFirst = m_specs.size() == 1 && m_specs.front().curves.empty();
    if (plot < 0 || plot >= static_cast<int>(m_specs.size())) {
        plot = isFirst ? 0 : static_cast<int>(m_specs.size());
    }
    if (plot == static_cast<int>(m_specs.size())) {
        m_specs.push_back(placedIn(m_specs, m_columns.empty() ? 0 : columnCount() - 1, {}));
    }
    PlotSpec& spec = m_specs[static_cast<std::size_t>(plot)];
    const bool isThere = std::any_of(spec.curves.begin(), spec.curves.end(),
                                     [&](const PlotCurve& other) { return other.signal == curve.signal; });
    if (isThere) {
        return;
    }
    if (spec.curves.empty() && spec.quantity.isEmpty()) {
        spec.quantity = curve.label;
        spec.unit = curve.unit;
    }
    spec.curves.push_back(curve);
    matchRows();
}

void LivePlotStack::removeCurve(int plot, const std::string& signal) {
    if (plot < 0 || plot >= static_cast<int>(m_specs.size())) {
        return;
    }
    std::vector<PlotCurve>& curves = m_specs[static_cast<std::size_t>(plot)].curves;
    std::erase_if(curves, [&](const PlotCurve& curve) { return curve.signal == signal; });
    settleAxes(m_specs[static_cast<std::size_t>(plot)]);
    if (curves.empty()) {
        removePlot(plot);
    } else {
        shapeChanged();
    }
}

void LivePlotStack::setTheme(const Theme& theme) {
    m_theme = theme;
    QPalette colours = palette();
    colours.setColor(QPalette::Window, theme.window); // seen between the plots
    setPalette(colours);
    setAutoFillBackground(true);
    for (const Row& row : m_rows) {
        row.plot->setTheme(theme);
        row.legend->setTheme(theme);
        row.timeAxis->setTheme(theme);
    }
    for (const Column& column : m_columns) {
        column.timeAxis->setTheme(theme);
    }
    m_cursorBar->setTheme(theme);
    m_markerBar->setTheme(theme);
    m_isDirty = true;
}

LivePlotStack::Row LivePlotStack::makeRow() {
    Row row;
    row.box = new QWidget(this);
    auto* column = new QVBoxLayout(row.box);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* layout = new QVBoxLayout; // plot and, where it does not stand in it, legend
    column->addLayout(layout, 1);
    row.parts = layout;
    row.plot = new LivePlot(row.box);
    row.legend = new LiveLegend(row.box);
    row.timeAxis = new TimeAxisBar(row.box);
    row.timeAxis->hide();
    row.timeAxis->setTheme(m_theme);
    connect(row.timeAxis, &TimeAxisBar::zoomRequested, row.plot, &LivePlot::zoomRequested);
    connect(row.timeAxis, &TimeAxisBar::panRequested, row.plot, &LivePlot::panRequested);
    connect(row.timeAxis, &TimeAxisBar::fitRequested, row.plot, &LivePlot::fitRequested);
    column->addWidget(row.timeAxis);
    layout->addWidget(row.plot, 1);
    row.plot->setTheme(m_theme);
    row.legend->setTheme(m_theme);
    row.plot->canvas()->installEventFilter(this);
    return row;
}

int LivePlotStack::indexOf(const LivePlot* plot) const {
    const auto found =
        std::find_if(m_rows.begin(), m_rows.end(), [plot](const Row& row) { return row.plot == plot; });
    return static_cast<int>(found - m_rows.begin());
}

void LivePlotStack::connectPlot(LivePlot* plot) {
    connect(plot, &LivePlot::zoomRequested, this,
            [this, plot](double factor, double at_s) { zoomTime(viewOf(indexOf(plot)), factor, at_s); });
    connect(plot, &LivePlot::viewAboutToChange, this, &LivePlotStack::remember);
    connect(plot, &LivePlot::fitRequested, this, &LivePlotStack::fitAll);
    connect(plot, &LivePlot::cursorMoved, this, &LivePlotStack::setCursor);
    connect(plot, &LivePlot::pairPicked, this, [this](int pair) {
        m_pairs.choose(static_cast<std::size_t>(pair));
        placeCursors();
    });
    connect(plot, &LivePlot::markerPicked, this,
            [this](int marker) { chooseMarker(static_cast<std::size_t>(marker)); });
    connect(plot, &LivePlot::levelMoved, this, &LivePlotStack::levelMoved);
    connect(plot, &LivePlot::valuesChanged, this, [this] { m_isDirty = true; });
    connect(plot, &LivePlot::panRequested, this, [this, plot](double by_s) {
        const bool wasFollowing = isFollowing();
        viewOf(indexOf(plot)).pan(by_s);
        changed(wasFollowing, isPaused());
    });
    connect(plot, &LivePlot::boxChosen, this, [this, plot](control::TimeRange time, ValueRange values) {
        const bool wasFollowing = isFollowing();
        remember();
        plot->zoomValues(values);
        viewOf(indexOf(plot)).show(time);
        changed(wasFollowing, isPaused());
    });
    connect(plot, &LivePlot::signalsDropped, this,
            [this, plot](const QStringList& names) { Q_EMIT signalsDropped(indexOf(plot), names); });
    connect(plot, &LivePlot::signalsDroppedBeside, this,
            [this, plot](const QStringList& names) { Q_EMIT signalsDroppedBeside(indexOf(plot), names); });
}

void LivePlotStack::matchRows() {
    while (m_rows.size() < m_specs.size()) {
        addRow(m_rows.size());
    }
    while (m_rows.size() > m_specs.size()) {
        removeRow(m_rows.size() - 1);
    }
    place();
    nameCurves();
    m_colours.update(m_specs, m_looks);
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        configureRow(i);
    }
    m_isDirty = true;
}

void LivePlotStack::configureRow(std::size_t index) {
    Row& row = m_rows[index];
    const bool isTopmost = index == 0 || m_specs[index - 1].column != m_specs[index].column;
    row.plot->setNamesShown(isTopmost);
    row.legend->setCursorColumnsShown(cursors().isVisible, isTopmost);
    row.plot->setMarkers(m_markers, m_chosenMarker);
    row.plot->setCursors(m_pairs);
    row.plot->setEvent(m_event_s);
    row.plot->setLevel(m_level);
    matchTime(index);
    row.plot->setColumn(columnCount() > 1 ? std::optional(m_specs[index].column) : std::nullopt);
    PlotSpec wanted = m_specs[index];
    wanted.ownTime = row.plot->spec().ownTime; // is no matter of the plot
    wanted.column = row.plot->spec().column;   // nor are these
    wanted.height_ratio = row.plot->spec().height_ratio;
    wanted.width_ratio = row.plot->spec().width_ratio;
    const bool isSame = row.plot->spec() == wanted && row.plot->history() == m_history;
    if (!row.isConfigured || !isSame) { // else it keeps its zoom and its hidden curves
        row.isConfigured = true;
        row.legend->table().setCurves({});
        row.plot->setReference(m_reference);
        row.plot->setSpec(m_specs[index], m_history, m_colours);
        row.legend->table().setCurves(row.plot->curves());
    }
    row.legend->setAccessibleName(tr("Live values of %1").arg(row.plot->accessibleName()));
}

void LivePlotStack::rescale(bool keepsHeld) {
    for (const Row& row : m_rows) {
        row.plot->rescale(keepsHeld);
    }
    m_zoomHistory.clear(); // of what was shown before
    m_isDirty = true;
}

ValueRange LivePlotStack::valueRange(int plot, bool isRight) const {
    return m_rows.at(static_cast<std::size_t>(plot)).plot->shownRange(isRight);
}

std::optional<ValueRange> LivePlotStack::heldRange(int plot, bool isRight) const {
    const HeldRanges held = m_rows.at(static_cast<std::size_t>(plot)).plot->heldRanges();
    return isRight ? held.right : held.left;
}

} // namespace halbench::widgets
