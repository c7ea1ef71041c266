// The columns of a stack of plots: which plot stands where, and how one gets beside another.
#include "widgets/controls/share_splitter.h"
#include "widgets/live_plot/axes/time_axis_bar.h"
#include "widgets/live_plot/live_legend.h"
#include "widgets/live_plot/live_plot.h"
#include "widgets/live_plot/live_plot_stack.h"

#include <QAction>
#include <QApplication>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace halbench::widgets {
namespace {

constexpr int HandleWidth = 4;

std::ptrdiff_t countBefore(const std::vector<PlotSpec>& plots, int column) {
    return std::count_if(plots.begin(), plots.end(),
                         [column](const PlotSpec& plot) { return plot.column < column; });
}

std::ptrdiff_t countIn(const std::vector<PlotSpec>& plots, int column) {
    return countBefore(plots, column + 1) - countBefore(plots, column);
}

/// Those from that column on go one further to the right.
void makeRoom(std::vector<PlotSpec>& plots, int column) {
    for (PlotSpec& plot : plots) {
        plot.column += plot.column >= column ? 1 : 0;
    }
}

} // namespace

LivePlotStack::Column LivePlotStack::makeColumn() {
    Column column;
    column.box = new QWidget(m_splitter);
    auto* layout = new QVBoxLayout(column.box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    column.rows = new ShareSplitter(Qt::Vertical, column.box);
    column.rows->setHandleWidth(HandleWidth);
    column.rows->setProperty("surface", QStringLiteral("plots"));
    connect(column.rows, &ShareSplitter::sharesChanged, this,
            [this, rows = column.rows] { takeHeights(*rows); });
    column.timeAxis = new TimeAxisBar(column.box);
    column.timeAxis->setTheme(m_theme);
    connect(column.timeAxis, &TimeAxisBar::zoomRequested, this,
            [this](double factor, double at_s) { zoomTime(m_view, factor, at_s); });
    connect(column.timeAxis, &TimeAxisBar::panRequested, this, [this](double by_s) {
        const bool wasFollowing = isFollowing();
        m_view.pan(by_s);
        changed(wasFollowing, isPaused());
    });
    connect(column.timeAxis, &TimeAxisBar::fitRequested, this, &LivePlotStack::fitAll);
    layout->addWidget(column.rows, 1);
    layout->addWidget(column.timeAxis);
    m_splitter->addWidget(column.box);
    return column;
}

std::vector<const LivePlotStack::Row*> LivePlotStack::rowsOf(int column) const {
    std::vector<const Row*> rows;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        if (m_specs[i].column == column) {
            rows.push_back(&m_rows[i]);
        }
    }
    return rows;
}

/// It stands nowhere until place().
void LivePlotStack::addRow(std::size_t at) {
    const auto row = m_rows.insert(m_rows.begin() + static_cast<std::ptrdiff_t>(at), makeRow());
    connectPlot(row->plot);
    connectLegend(row->plot, row->legend);
}

void LivePlotStack::removeRow(std::size_t at) {
    const Row row = m_rows[at];
    row.plot->disconnect(this);
    row.legend->disconnect(this);
    row.box->hide();
    row.box->setParent(this); // out of its column
    row.box->deleteLater();   // the request may come from one of its own signals
    m_rows.erase(m_rows.begin() + static_cast<std::ptrdiff_t>(at));
}

/// Puts every plot where its description says; a widget that is moved keeps the focus.
void LivePlotStack::place() {
    QWidget* focused = QApplication::focusWidget();
    const bool isOurs = focused != nullptr && m_splitter->isAncestorOf(focused);
    const auto count = static_cast<std::size_t>(m_specs.back().column) + 1;
    while (m_columns.size() < count) {
        m_columns.push_back(makeColumn());
    }
    std::vector<bool> hasOtherPlots(count, false);
    std::vector<int> places(count, 0);
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const auto column = static_cast<std::size_t>(m_specs[i].column);
        ShareSplitter* rows = m_columns[column].rows;
        const int at = places[column]++;
        if (rows->indexOf(m_rows[i].box) != at) {
            rows->insertWidget(at, m_rows[i].box);
            hasOtherPlots[column] = true;
        }
    }
    matchColumns(count);
    for (std::size_t i = 0; i < count; ++i) {
        Column& column = m_columns[i];
        if (hasOtherPlots[i] || column.rows->count() != column.count) {
            column.count = column.rows->count();
            column.extent_px = 0;
            column.rightExtent_px = 0;
        }
    }
    shareRoom();
    if (std::find(hasOtherPlots.begin(), hasOtherPlots.end(), true) != hasOtherPlots.end()) {
        chainFocus();
    }
    if (isOurs && m_splitter->isAncestorOf(focused) && !focused->hasFocus()) {
        focused->setFocus();
    }
}

/// Takes away those that nothing stands in any more, and says which one is which.
void LivePlotStack::matchColumns(std::size_t count) {
    while (m_columns.size() > count) {
        QWidget* box = m_columns.back().box;
        box->hide();
        box->setParent(this);
        box->deleteLater();
        m_columns.pop_back();
    }
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
        m_columns[i].timeAxis->setAccessibleName(count > 1 ? tr("Time axis of column %1").arg(i + 1)
                                                           : tr("Time axis"));
    }
}

/// Tab goes down a column, each plot with its legend, then to the next one.
void LivePlotStack::chainFocus() const {
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        if (i > 0) {
            QWidget::setTabOrder(m_rows[i - 1].legend, m_rows[i].plot);
        }
        QWidget::setTabOrder(m_rows[i].plot, m_rows[i].legend);
    }
}

void LivePlotStack::shapeChanged() {
    settleColumns(m_specs);
    settleSizes(m_specs);
    m_zoomHistory.clear(); // its entries belong to the plots as they were
    matchRows();
}

void LivePlotStack::openPlot(int at, PlotSpec plot) {
    const int column = at > 0 ? m_specs[static_cast<std::size_t>(at) - 1].column : 0;
    m_specs.insert(m_specs.begin() + at, placedIn(m_specs, column, std::move(plot)));
    addRow(static_cast<std::size_t>(at));
    shapeChanged();
}

int LivePlotStack::openBeside(int plot, PlotSpec added) {
    const int column = m_specs.at(static_cast<std::size_t>(plot)).column + 1;
    makeRoom(m_specs, column);
    const std::ptrdiff_t at = countBefore(m_specs, column);
    m_specs.insert(m_specs.begin() + at, placedIn(m_specs, column, std::move(added)));
    addRow(static_cast<std::size_t>(at));
    shapeChanged();
    return static_cast<int>(at);
}

void LivePlotStack::removePlot(int plot) {
    if (plot < 0 || plot >= static_cast<int>(m_specs.size())) {
        return;
    }
    const auto index = static_cast<std::size_t>(plot);
    const bool hadLegend = m_rows[index].legend->hasFocus();
    const bool hadFocus = hadLegend || m_rows[index].plot->hasFocus();
    m_specs.erase(m_specs.begin() + plot);
    removeRow(index);
    if (m_specs.empty()) {
        m_specs.emplace_back();
    }
    shapeChanged();
    if (hadFocus) { // goes on to what stands there now
        const Row& next = m_rows[std::min(index, m_rows.size() - 1)];
        next.plot->setFocus();
        if (hadLegend) {
            next.legend->setFocus();
        }
    }
}

/// To that place of a column, or to its end where it has fewer.
void LivePlotStack::put(int plot, int column, std::ptrdiff_t position) {
    PlotSpec spec = m_specs[static_cast<std::size_t>(plot)];
    const Row row = m_rows[static_cast<std::size_t>(plot)]; // with what the user did to it
    m_specs.erase(m_specs.begin() + plot);
    m_rows.erase(m_rows.begin() + plot);
    const std::ptrdiff_t at = countBefore(m_specs, column) + std::min(position, countIn(m_specs, column));
    m_specs.insert(m_specs.begin() + at, placedIn(m_specs, column, std::move(spec)));
    m_rows.insert(m_rows.begin() + at, row);
    shapeChanged();
}

bool LivePlotStack::movePlot(int plot, int by) {
    if (plot < 0 || plot >= static_cast<int>(m_specs.size())) {
        return false;
    }
    const int column = m_specs[static_cast<std::size_t>(plot)].column;
    const int to = column + by;
    const bool isBeyond = to < 0 || to >= columnCount();
    if (isBeyond && countIn(m_specs, column) < 2) {
        return false;
    }
    const std::ptrdiff_t position = plot - countBefore(m_specs, column);
    if (to < 0) {
        makeRoom(m_specs, 0);
    }
    put(plot, std::max(to, 0), position);
    return true;
}

bool LivePlotStack::separateBeside(int plot, const std::string& signal) {
    if (std::optional<PlotSpec> own = ownPlotOf(plot, signal)) {
        openBeside(plot, *std::move(own));
        removeCurve(plot, signal);
        return true;
    }
    if (plot < 0 || plot >= static_cast<int>(m_specs.size())) {
        return false;
    }
    const PlotSpec& whole = m_specs[static_cast<std::size_t>(plot)];
    const int column = whole.column;
    if (whole.curves.size() != 1 || whole.curves.front().signal != signal || countIn(m_specs, column) < 2) {
        return false;
    }
    makeRoom(m_specs, column + 1);
    put(plot, column + 1, 0);
    return true;
}

std::optional<int> LivePlotStack::plotBeside(int plot, int by) const {
    const int column = m_specs[static_cast<std::size_t>(plot)].column;
    const std::ptrdiff_t count = countIn(m_specs, column + by);
    if (count == 0) {
        return std::nullopt;
    }
    const std::ptrdiff_t position = plot - countBefore(m_specs, column);
    return static_cast<int>(countBefore(m_specs, column + by) + std::min(position, count - 1));
}

void LivePlotStack::createPlotActions() {
    addAction(Command::PlotRight, tr("Plot to the right"), QStringLiteral("L"),
              tr("Move the plot to the column on the right, or to a new column"));
    addAction(Command::PlotLeft, tr("Plot to the left"), QStringLiteral("Shift+L"),
              tr("Move the plot to the column on the left, or to a new column"));
    addAction(Command::NewBeside, tr("New plot on the right"), QStringLiteral("Ctrl+Shift+Right"),
              tr("Empty plot in a new column"));
    addAction(Command::RemovePlot, tr("Remove the plot"), QStringLiteral("Shift+Del"),
              tr("Remove the plot with its curves"));
    createSizeActions();
}

void LivePlotStack::runOnPlots(Command command) {
    const std::optional<int> focused = focusedPlot();
    if (command == Command::NewBeside) {
        const int added = openBeside(activePlot(), {});
        m_rows[static_cast<std::size_t>(added)].plot->setFocus();
    } else if (command == Command::RemovePlot) {
        if (!focused) {
            return; // nobody said which one
        }
        removePlot(*focused);
    } else if (!movePlot(activePlot(), command == Command::PlotRight ? 1 : -1)) {
        return;
    }
    Q_EMIT plotsChanged();
}

} // namespace halbench::widgets
