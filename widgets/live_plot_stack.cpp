#include "widgets/live_plot_stack.h"

#include "widgets/cursor_bar.h"
#include "widgets/live_legend.h"
#include "widgets/live_plot.h"
#include "widgets/theme_style.h"
#include "widgets/time_axis_bar.h"

#include <QAction>
#include <QHBoxLayout>
#include <QSplitter>
#include <QTimer>
#include <QVBoxLayout>
#include <QVector>

#include <algorithm>
#include <utility>

namespace halbench::widgets {
namespace {

constexpr int FramePeriod_ms = 33; ///< 30 frames a second
constexpr int HandleWidth = 4;
constexpr int EvenShare = 1000; ///< the splitter makes heights of it

} // namespace

LivePlotStack::LivePlotStack(QWidget* parent)
    : QWidget(parent), m_splitter(new QSplitter(Qt::Vertical, this)), m_timeAxis(new TimeAxisBar(this)),
      m_cursorBar(new CursorBar(this)), m_timer(new QTimer(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_splitter, 1);
    layout->addWidget(m_timeAxis);
    layout->addWidget(m_cursorBar);
    m_splitter->setHandleWidth(HandleWidth);
    m_splitter->setChildrenCollapsible(false);
    m_cursorBar->hide();
    createActions();
    connectCursorBar();
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
    m_zoomHistory.clear();
    m_extent_px = 0;
    m_rightExtent_px = 0;
    matchRows();
}

void LivePlotStack::addCurve(int plot, const PlotCurve& curve) {
    const bool isFirst = m_specs.size() == 1 && m_specs.front().curves.empty();
    if (plot < 0 || plot >= static_cast<int>(m_specs.size())) {
        plot = isFirst ? 0 : static_cast<int>(m_specs.size());
    }
    if (plot == static_cast<int>(m_specs.size())) {
        m_specs.emplace_back();
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
        m_specs.erase(m_specs.begin() + plot);
        for (std::size_t i = static_cast<std::size_t>(plot) + 1; i < m_rows.size(); ++i) {
            m_rows[i - 1].time = m_rows[i].time; // goes up with its plot
        }
    }
    if (m_specs.empty()) {
        m_specs.emplace_back();
    }
    m_zoomHistory.clear(); // its entries belong to the plots as they were
    matchRows();
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
    m_timeAxis->setTheme(theme);
    m_cursorBar->setTheme(theme);
    m_isDirty = true;
}

LivePlotStack::Row LivePlotStack::makeRow() {
    Row row;
    row.box = new QWidget;
    auto* column = new QVBoxLayout(row.box);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* layout = new QHBoxLayout;
    column->addLayout(layout, 1);
    row.plot = new LivePlot(row.box);
    row.legend = new LiveLegend(row.box);
    row.timeAxis = new TimeAxisBar(row.box);
    row.timeAxis->hide();
    row.timeAxis->setTheme(m_theme);
    column->addWidget(row.timeAxis);
    layout->addWidget(row.plot, 1);
    layout->addWidget(row.legend);
    row.plot->setTheme(m_theme);
    row.legend->setTheme(m_theme);
    row.plot->canvas()->installEventFilter(this);
    m_splitter->addWidget(row.box);
    return row;
}

void LivePlotStack::addRow() {
    m_rows.push_back(makeRow());
    connectPlot(static_cast<int>(m_rows.size()) - 1);
    m_splitter->setSizes(evenShares());
}

void LivePlotStack::connectPlot(int index) {
    LivePlot* plot = m_rows[static_cast<std::size_t>(index)].plot;
    connectLegend(index);
    connect(plot, &LivePlot::zoomRequested, this,
            [this, index](double factor, double at_s) { zoomTime(viewOf(index), factor, at_s); });
    connect(plot, &LivePlot::viewAboutToChange, this, &LivePlotStack::remember);
    connect(plot, &LivePlot::fitRequested, this, &LivePlotStack::fitAll);
    connect(plot, &LivePlot::cursorMoved, this, &LivePlotStack::setCursor);
    connect(plot, &LivePlot::pairPicked, this, [this](int pair) {
        m_pairs.choose(static_cast<std::size_t>(pair));
        placeCursors();
    });
    connect(plot, &LivePlot::levelMoved, this, &LivePlotStack::levelMoved);
    connect(plot, &LivePlot::valuesChanged, this, [this] { m_isDirty = true; });
    connect(plot, &LivePlot::panRequested, this, [this, index](double by_s) {
        const bool wasFollowing = isFollowing();
        viewOf(index).pan(by_s);
        changed(wasFollowing, isPaused());
    });
    connect(plot, &LivePlot::boxChosen, this,
            [this, plot, index](control::TimeRange time, ValueRange values) {
                const bool wasFollowing = isFollowing();
                remember();
                plot->zoomValues(values);
                viewOf(index).show(time);
                changed(wasFollowing, isPaused());
            });
    connect(plot, &LivePlot::signalsDropped, this,
            [this, index](const QStringList& names) { Q_EMIT signalsDropped(index, names); });
}

/// Other plots are equally high at first, whatever room those had that went.
QList<int> LivePlotStack::evenShares() const {
    return QVector<int>(static_cast<int>(m_rows.size()), EvenShare).toList();
}

void LivePlotStack::matchRows() {
    const std::size_t before = m_rows.size();
    while (m_rows.size() < m_specs.size()) {
        addRow();
    }
    while (m_rows.size() > m_specs.size()) {
        m_rows.back().box->hide();
        m_rows.back().box->setParent(this); // out of the splitter
        m_rows.back().box->deleteLater();   // the request may come from one of its own signals
        m_rows.pop_back();
    }
    if (m_rows.size() != before) {
        m_splitter->setSizes(evenShares());
    }
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        configureRow(i);
    }
    m_isDirty = true;
}

void LivePlotStack::configureRow(std::size_t index) {
    Row& row = m_rows[index];
    row.plot->setNamesShown(index == 0);
    row.plot->setMarkers(m_markers);
    row.plot->setCursors(m_pairs);
    row.plot->setEvent(m_event_s);
    row.plot->setLevel(m_level);
    matchTime(index);
    PlotSpec wanted = m_specs[index];
    wanted.ownTime = row.plot->spec().ownTime; // is no matter of the plot
    if (row.isConfigured && row.plot->spec() == wanted && row.plot->history() == m_history) {
        return; // keeps its zoom and its hidden curves
    }
    row.isConfigured = true;
    row.legend->table().setCurves({});
    row.plot->setReference(m_reference);
    row.plot->setSpec(m_specs[index], m_history);
    row.legend->table().setCurves(row.plot->curves());
    row.legend->setCursorColumnsShown(cursors().isVisible, index == 0);
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
