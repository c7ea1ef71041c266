// What a stack of plots does each frame.
#include "widgets/language/display_units.h"
#include "widgets/live_plot/axes/time_axis_bar.h"
#include "widgets/live_plot/cursor_bar.h"
#include "widgets/live_plot/live_legend.h"
#include "widgets/live_plot/live_plot.h"
#include "widgets/live_plot/live_plot_stack.h"
#include "widgets/live_plot/stale_text.h"
#include "widgets/theme/theme_style.h"

#include <QBoxLayout>
#include <QEvent>

#include <algorithm>
#include <array>
#include <cmath>

namespace halbench::widgets {
namespace {

constexpr int FramesPerNumber = 3;   ///< numbers change ten times a second
constexpr int CharactersPerTick = 9; ///< room of a label of the time axis
constexpr double WidestLegend_ratio = 0.45;
constexpr int LegendInset_px = 4;          ///< of a legend in its plot
constexpr double WidestInside_ratio = 0.5; ///< of one of several columns; wider ones stand below their plots

/// Axis titles from the best to read to the shortest.
constexpr std::array<TitleForm, 6> TitleForms{
    {{false, 1.0}, {false, 0.9}, {false, 0.8}, {true, 1.0}, {true, 0.85}, {true, 0.7}}};

} // namespace

void LivePlotStack::refresh() {
    if (window()->isMinimized()) {
        return; // the owner takes in what arrives at a pace of its own
    }
    Q_EMIT frameStarting();
    if (!isVisible()) {
        return;
    }
    const std::optional<std::uint64_t> revision =
        m_history != nullptr ? std::optional(m_history->revision()) : std::nullopt;
    if (!m_isDirty && revision == m_drawnRevision) {
        return;
    }
    // A paused view shows the same whatever arrives, once all of it is here; only its state counts on.
    const bool isWhole =
        std::all_of(m_rows.begin(), m_rows.end(), [](const Row& row) { return row.plot->isWhole(); });
    if (m_isDirty || !isPaused() || !isWhole) {
        drawFrame();
    } else {
        updateViews();
    }
    const auto legendDigits = [this] {
        std::vector<int> digits;
        for (const Row& row : m_rows) {
            digits.push_back(row.legend->table().digits());
        }
        return digits;
    };
    bool areWider = false;
    if (m_isDirty || !m_areNumbersWhole || ++m_framesSinceNumbers >= FramesPerNumber) {
        const std::vector<int> before = legendDigits();
        m_framesSinceNumbers = 0;
        m_areNumbersWhole = showNumbers();
        showState();
        areWider = legendDigits() != before;
    }
    for (const Row& row : m_rows) {
        row.legend->keepPicture();
    }
    m_drawnRevision = revision;
    m_isDirty = areWider; // the next frame gives them the room
}

int LivePlotStack::deviceColumns(int column) const {
    const QWidget* canvas = rowsOf(column).front()->plot->canvas();
    return std::max(1, static_cast<int>(std::lround((canvas->width() - 1) * canvas->devicePixelRatioF())));
}

double LivePlotStack::timeStep_s(const TimeView& view, int column) const {
    const int room = fontMetrics().averageCharWidth() * CharactersPerTick;
    const int labels = std::max(1, rowsOf(column).front()->plot->canvas()->width() / std::max(1, room));
    return niceStep(view.range().length_s(), labels);
}

void LivePlotStack::updateViews() {
    const std::optional<control::TimeRange> held = m_history != nullptr ? m_history->range() : std::nullopt;
    m_view.update(held, deviceColumns(0));
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        if (m_rows[i].time) {
            m_rows[i].time->update(held, deviceColumns(m_specs[i].column));
        }
    }
}

void LivePlotStack::drawFrame() {
    updateViews();
    for (int column = 0; column < columnCount(); ++column) {
        drawColumn(column);
        if (m_isDirty) { // titles and the height of the plots do not change with the data
            fitTitles(column);
        }
        align(column);
    }
}

/// The time that all share; while it follows it moves by whole pixels of this column, as each does.
void LivePlotStack::drawColumn(int column) {
    TimeView shared = m_view;
    shared.update(m_history != nullptr ? m_history->range() : std::nullopt, deviceColumns(column));
    for (const Row* row : rowsOf(column)) {
        const TimeView& view = row->time ? *row->time : shared;
        row->plot->showFrame(view.range(), timeStep_s(view, column), view.drawn());
        if (row->time) {
            row->timeAxis->setRange(view.range(), timeStep_s(view, column), m_event_s);
        }
    }
    m_columns[static_cast<std::size_t>(column)].timeAxis->setRange(shared.range(), timeStep_s(shared, column),
                                                                   m_event_s);
}

/// The same for all of a column, so that their axes align.
void LivePlotStack::fitTitles(int column) {
    const std::vector<const Row*> rows = rowsOf(column);
    const auto isWhole = [&rows](const TitleForm& form) {
        return std::all_of(rows.begin(), rows.end(),
                           [&form](const Row* row) { return row->plot->isTitleWhole(form); });
    };
    const auto form = std::find_if(TitleForms.begin(), TitleForms.end(), isWhole);
    for (const Row* row : rows) {
        row->plot->setTitleForm(form != TitleForms.end() ? *form : TitleForms.back());
    }
}

/// A legend stands in its plot; where columns share the width and it would cover most of the canvas, below.
/// Whether it does.
bool LivePlotStack::placeLegends(int column, int wanted_px) {
    const int width_px = m_columns[static_cast<std::size_t>(column)].box->width();
    const bool areBelow = columnCount() > 1 && wanted_px > WidestInside_ratio * width_px;
    for (const Row* row : rowsOf(column)) {
        const bool isLaidOut = row->parts->indexOf(row->legend) >= 0;
        if (areBelow && !isLaidOut) {
            row->parts->addWidget(row->legend);
            row->legend->show();
        } else if (!areBelow && isLaidOut) {
            row->parts->removeWidget(row->legend);
        }
        row->legend->setBelow(areBelow);
    }
    return areBelow;
}

void LivePlotStack::align(int index) {
    Column& here = m_columns[static_cast<std::size_t>(index)];
    const std::vector<const Row*> rows = rowsOf(index);
    const bool hasRight =
        std::any_of(rows.begin(), rows.end(), [](const Row* row) { return hasRightAxis(row->plot->spec()); });
    LiveLegend::Widths widths{};
    int leastName_px = 0;
    for (const Row* row : rows) {
        here.extent_px = std::max(here.extent_px, row->plot->neededExtent()); // only grows: nothing jumps
        here.rightExtent_px = std::max(here.rightExtent_px, row->plot->neededRightExtent());
        const LiveLegend::Widths own = row->legend->neededWidths();
        for (std::size_t i = 0; i < widths.size(); ++i) {
            widths[i] = std::max(widths[i], own[i]);
        }
        leastName_px = std::max(leastName_px, row->legend->leastNameWidth());
    }
    int numbers_px = 0;
    for (int column = LegendTableModel::Value; column < LegendTableModel::Columns; ++column) {
        const bool isShown =
            cursors().isVisible || column == LegendTableModel::Value || column == LegendTableModel::Unit;
        numbers_px += isShown ? widths[static_cast<std::size_t>(column)] : 0;
    }
    int total_px = widths[LegendTableModel::Name] + numbers_px;
    const bool areBelow = placeLegends(index, total_px);
    if (areBelow) {
        total_px = here.box->width();
    } else { // Names give way to the plots; a number that is cut is another number.
        const int share_px = static_cast<int>(WidestLegend_ratio * here.box->width());
        const int now_px = widths[LegendTableModel::Value];
        const int hidden_px =
            cursors().isVisible && total_px > share_px ? now_px : 0; // LiveLegend::setWidths
        total_px = std::max(numbers_px - hidden_px + leastName_px, std::min(total_px - hidden_px, share_px));
    }
    for (const Row* row : rows) {
        row->plot->setExtent(here.extent_px);
        row->plot->setRightExtent(hasRight ? std::optional(here.rightExtent_px) : std::nullopt);
        row->legend->setWidths(widths, total_px);
        if (!areBelow) {
            const QRect canvas = row->plot->canvasRect().translated(row->plot->pos());
            row->legend->setInside(
                canvas.adjusted(LegendInset_px, LegendInset_px, -LegendInset_px, -LegendInset_px), total_px);
        }
    }
    const QRect canvas = rows.front()->plot->canvasRect();
    const QPoint left = rows.front()->plot->mapTo(here.box, canvas.topLeft());
    here.timeAxis->setCanvas(left.x() - here.timeAxis->x(), canvas.width());
    for (const Row* row : rows) {
        row->timeAxis->setCanvas(row->plot->x() + row->plot->canvasRect().x(), canvas.width());
    }
}

/// Whether all of them are known: what the disk has not given yet has a dash.
bool LivePlotStack::showNumbers() {
    std::optional<control::SampleHistory::Glance> glance;
    if (m_history != nullptr) {
        glance.emplace(*m_history);
    }
    const std::optional<control::TimeRange> held = m_history != nullptr ? m_history->range() : std::nullopt;
    for (const Row& row : m_rows) {
        std::vector<LegendNumbers> numbers(row.plot->curves().size());
        for (std::size_t i = 0; held && i < numbers.size(); ++i) {
            const PlotCurve& curve = row.plot->curves()[i]->curve();
            const auto shown = [&](const std::optional<control::TimedValue>& sample) {
                return sample && !std::isnan(sample->value) ? std::optional(curve.factor * sample->value)
                                                            : std::nullopt;
            };
            const auto latest = m_history->latest(curve.signal);
            numbers[i].value = shown(isPaused() ? m_history->valueAt(curve.signal, m_view.now_s()) : latest);
            numbers[i].stale = staleWords(*m_history, curve.signal, m_stale);
            if (const CursorPair pair = cursors(); pair.isVisible) {
                numbers[i].atA = shown(m_history->valueAt(curve.signal, pair.a_s));
                numbers[i].atB = shown(m_history->valueAt(curve.signal, pair.b_s));
            }
        }
        row.legend->table().setNumbers(numbers);
    }
    return !glance || glance->isWhole();
}

void LivePlotStack::showOwnState(const Row& row) {
    const QString length = numberText(row.time->range().length_s(), 4);
    if (!m_isLive) {
        row.timeAxis->setState(tr("Own time axis, %1 s").arg(length), false);
    } else if (isPaused()) {
        row.timeAxis->setState(tr("Own time axis, paused"), true);
    } else if (row.time->isFollowing()) {
        row.timeAxis->setState(tr("Own time axis, following, %1 s").arg(length), false);
    } else {
        row.timeAxis->setState(tr("Own time axis, paused in history (End: live)"), true);
    }
}

void LivePlotStack::showState() {
    showChecks(); // the focus may have gone to another axis
    if (cursors().isVisible) {
        m_cursorBar->setResolution(activeView().range().length_s(), samplePeriod_s());
    }
    for (const Row& row : m_rows) {
        if (row.time) {
            showOwnState(row);
        }
    }
    // Once is enough: the others show the same time.
    const auto first = std::find_if(m_columns.begin(), m_columns.end(),
                                    [](const Column& column) { return !column.timeAxis->isHidden(); });
    for (auto column = m_columns.begin(); column != m_columns.end(); ++column) {
        const bool isWarning = m_isLive && (isPaused() || !isFollowing() || !m_stale.isEmpty());
        column->timeAxis->setState(column == first ? stateWords() : QString(), isWarning);
    }
}

QString LivePlotStack::stateWords() const {
    if (!m_isLive) {
        return tr("Recorded data, %1 s").arg(numberText(m_view.range().length_s(), 4));
    }
    if (isPaused()) {
        return tr("Paused for %1 s").arg(fixedText(m_view.behind_s(), 1));
    }
    if (!isFollowing()) {
        return m_event_s ? tr("Triggered view (End: live)") : tr("Paused in history (End: live)");
    }
    return m_stale.isEmpty() ? tr("Following, %1 s").arg(numberText(m_view.range().length_s(), 4)) : m_stale;
}

void LivePlotStack::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::StyleChange && currentTheme().name != m_theme.name) {
        setTheme(currentTheme());
    }
    if (event->type() == QEvent::FontChange) {
        for (Column& column : m_columns) {
            column.extent_px = 0;
            column.rightExtent_px = 0;
        }
        m_isDirty = true;
    }
}

bool LivePlotStack::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize) {
        m_isDirty = true; // other columns
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace halbench::widgets
