// Pairs of cursors over a stack of plots.
#include "widgets/live_plot/cursor_bar.h"
#include "widgets/live_plot/live_legend.h"
#include "widgets/live_plot/live_plot.h"
#include "widgets/live_plot/live_plot_stack.h"

#include <QAction>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::widgets {
namespace {

constexpr double PairShare_ratio = 0.5; ///< of the view that goes to a pair

} // namespace

void LivePlotStack::createCursorActions() {
    addAction(Command::Cursors, tr("Cursors"), QStringLiteral("C"),
              tr("Two measuring cursors; drag them or use the arrow keys"));
    addAction(Command::CursorA, tr("Cursor A"), QStringLiteral("A"), tr("Arrow keys move cursor A"));
    addAction(Command::CursorB, tr("Cursor B"), QStringLiteral("B"), tr("Arrow keys move cursor B"));
    addAction(Command::NewPair, tr("New cursor pair"), QStringLiteral("N"),
              tr("Add two cursors; the other pairs stay, faint"));
    addAction(Command::RemovePair, tr("Remove the cursor pair"), QStringLiteral("Shift+N"),
              tr("Remove the active pair"));
    addAction(Command::NextPair, tr("Next cursor pair"), QStringLiteral("P"), tr("Activate the next pair"));
    addAction(Command::PreviousPair, tr("Previous cursor pair"), QStringLiteral("Shift+P"),
              tr("Activate the previous pair"));
    addAction(Command::NamePair, tr("Name the cursor pair"), QStringLiteral("F2"),
              tr("Name of the active pair; saved in the project"));
    addAction(Command::ShowPair, tr("Go to the cursor pair"), QStringLiteral("G"),
              tr("Show the time around the active pair"));
    addAction(Command::PairHere, tr("Bring the cursor pair here"), QStringLiteral("Shift+C"),
              tr("Move the active pair into view"));
}

void LivePlotStack::connectCursorBar() {
    m_cursorBar->setPairActions({action(Command::NewPair), action(Command::NamePair),
                                 action(Command::RemovePair), action(Command::NextPair),
                                 action(Command::PreviousPair), action(Command::ShowPair),
                                 action(Command::PairHere)});
    connect(m_cursorBar, &CursorBar::cursorTyped, this, &LivePlotStack::setCursor);
    connect(m_cursorBar, &CursorBar::pairChosen, this, [this](int pair) {
        m_pairs.choose(static_cast<std::size_t>(pair));
        placeCursors();
    });
    connect(m_cursorBar, &CursorBar::nameTyped, this, &LivePlotStack::namePair);
    placeCursors();
}

void LivePlotStack::runOnPairs(Command command) {
    const bool wereVisible = cursors().isVisible;
    if (command == Command::Cursors) {
        return setCursorsVisible(!wereVisible);
    }
    if (command == Command::CursorA || command == Command::CursorB) {
        m_pairs.setActive(command == Command::CursorA ? 0 : 1);
    }
    setCursorsVisible(true);
    const control::TimeRange thirds = thirdsOfView();
    if (command == Command::NewPair && (wereVisible || m_pairs.areKept())) { // else the first one is new
        m_pairs.add(thirds.begin_s, thirds.end_s);
    } else if (command == Command::RemovePair && wereVisible) { // only what is seen
        m_pairs.remove();
    } else if (command == Command::NextPair || command == Command::PreviousPair) {
        m_pairs.chooseNext(command == Command::NextPair ? 1 : -1);
    } else if (command == Command::NamePair) {
        m_cursorBar->editName();
    } else if (command == Command::ShowPair) {
        return showPair();
    } else if (command == Command::PairHere) {
        const int active = cursors().active;
        m_pairs.move(0, thirds.begin_s);
        m_pairs.move(1, thirds.end_s);
        m_pairs.setActive(active);
    }
    placeCursors();
}

control::TimeRange LivePlotStack::thirdsOfView() const {
    const control::TimeRange& view = activeView().range();
    return {view.begin_s + view.length_s() / 3.0, view.begin_s + view.length_s() * 2.0 / 3.0};
}

/// Two cursors at one place keep the length of the view.
void LivePlotStack::showPair() {
    const CursorPair pair = cursors();
    const double apart_s = std::abs(pair.b_s - pair.a_s);
    const double length_s = apart_s > 0.0 ? apart_s / PairShare_ratio : activeView().range().length_s();
    const double middle_s = 0.5 * (pair.a_s + pair.b_s);
    const bool wasFollowing = isFollowing();
    remember();
    activeView().show({middle_s - 0.5 * length_s, middle_s + 0.5 * length_s});
    changed(wasFollowing, isPaused());
}

void LivePlotStack::namePair(const QString& name) {
    if (m_pairs.rename(name)) {
        placeCursors();
    } else {
        m_cursorBar->refuseName(
            name.trimmed().isEmpty()
                ? tr("A pair needs a name. Name unchanged: %1").arg(m_pairs.name())
                : tr("Pair %1 exists already. Name unchanged: %2").arg(name.trimmed(), m_pairs.name()));
    }
}

/// The pair that nobody named comes into the view; one with a name stays where it was put.
void LivePlotStack::setCursorsVisible(bool areVisible) {
    const CursorPair pair = cursors();
    const control::TimeRange& view = activeView().range();
    const auto isInView = [&](double time_s) { return time_s >= view.begin_s && time_s <= view.end_s; };
    if (areVisible && !pair.isVisible && !m_pairs.areKept() && !(isInView(pair.a_s) && isInView(pair.b_s))) {
        const control::TimeRange thirds = thirdsOfView();
        m_pairs.move(0, thirds.begin_s);
        m_pairs.move(1, thirds.end_s);
        m_pairs.setActive(pair.active);
    }
    m_pairs.setVisible(areVisible);
    placeCursors();
}

void LivePlotStack::setCursorPairs(CursorPairs pairs) {
    m_pairs = std::move(pairs);
    placeCursors();
}

void LivePlotStack::setCursor(int index, double time_s) {
    m_pairs.move(index, time_s);
    placeCursors();
}

/// Of the densest signal in view; nothing while there are not two rows of one.
std::optional<double> LivePlotStack::samplePeriod_s() const {
    const control::TimeRange view = activeView().range();
    std::optional<double> period_s;
    for (const PlotSpec& plot : m_specs) {
        for (const PlotCurve& curve : plot.curves) {
            const auto held = m_history != nullptr ? m_history->range(curve.signal) : std::nullopt;
            const control::TimeRange seen = held ? control::TimeRange{std::max(view.begin_s, held->begin_s),
                                                                      std::min(view.end_s, held->end_s)}
                                                 : control::TimeRange{};
            const std::size_t rows = seen.length_s() > 0.0 ? m_history->rowsIn(curve.signal, seen) : 0;
            if (rows > 1) {
                const double own_s = seen.length_s() / static_cast<double>(rows);
                period_s = std::min(period_s.value_or(own_s), own_s);
            }
        }
    }
    return period_s;
}

void LivePlotStack::placeCursors() {
    const bool areVisible = cursors().isVisible;
    for (const Row& row : m_rows) {
        row.plot->setCursors(m_pairs);
    }
    for (int column = 0; column < columnCount(); ++column) {
        const std::vector<const Row*> rows = rowsOf(column);
        for (const Row* row : rows) { // the topmost legend says the names for those below it
            row->legend->setCursorColumnsShown(areVisible, row == rows.front());
        }
    }
    m_cursorBar->setPairs(m_pairs);
    m_cursorBar->setVisible(areVisible);
    m_actions.at(Command::Cursors)->setChecked(areVisible);
    m_isDirty = true;
    Q_EMIT cursorsChanged();
}

void LivePlotStack::moveCursor(int columns) {
    const double column_s =
        activeView().range().length_s() / deviceColumns(m_specs[static_cast<std::size_t>(axisPlot())].column);
    setCursor(cursors().active, cursors().at(cursors().active) + columns * column_s);
}

} // namespace halbench::widgets
