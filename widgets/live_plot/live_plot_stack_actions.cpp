// What keys and tool bars do with a stack of plots.
#include "widgets/live_plot/live_legend.h"
#include "widgets/live_plot/live_plot.h"
#include "widgets/live_plot/live_plot_stack.h"

#include <QAction>
#include <QKeyEvent>

#include <algorithm>
#include <utility>

namespace halbench::widgets {
namespace {

constexpr double Scroll_ratio = 0.05; ///< of the view, without cursors
constexpr int CoarseColumns = 50;     ///< of a cursor step with Shift

} // namespace

void LivePlotStack::createActions() {
    addAction(Command::Pause, tr("Pause"), QStringLiteral("Space"), tr("Pause view (recording continues)"));
    addAction(Command::Follow, tr("Follow"), QStringLiteral("End"), tr("Keep the latest sample in view"));
    addAction(Command::Fit, tr("Fit"), QStringLiteral("F"),
              tr("Fit the value axes; in a paused view, show the whole history"));
    addAction(Command::ShowAll, tr("Show all"), QStringLiteral("Home"), tr("Show the whole history"));
    addAction(Command::ZoomBack, tr("Zoom back"), QStringLiteral("Backspace"), tr("Previous view"));
    addAction(Command::ZoomIn, tr("Zoom in"), QStringLiteral("+"), tr("Show a shorter time span"));
    addAction(Command::ZoomOut, tr("Zoom out"), QStringLiteral("-"), tr("Show a longer time span"));
    addAction(Command::ScrollBack, tr("Scroll back"), QStringLiteral("PgUp"), tr("Show earlier data"));
    addAction(Command::ScrollOn, tr("Scroll forward"), QStringLiteral("PgDown"), tr("Show later data"));
    createValueActions();
    createCursorActions();
    createMarkerActions();
    addAction(Command::KeepReference, tr("Keep as reference"), QStringLiteral("K"),
              tr("Keep the present curves as faint reference below the live curves"));
    addAction(Command::RemoveReference, tr("Remove the reference"), QStringLiteral("Shift+K"),
              tr("Remove the faint reference curves"));
    m_actions.at(Command::RemoveReference)->setEnabled(false);
    createTimeActions();
    createPlotActions();
    addAction(Command::AddSignals, tr("Add signals"), QStringLiteral("Insert"),
              tr("Choose the signals to plot"));
    for (const Command command : {Command::Pause, Command::Follow, Command::Cursors}) {
        m_actions.at(command)->setCheckable(true);
    }
    m_actions.at(Command::Follow)->setChecked(true);
}

void LivePlotStack::addAction(Command command, const QString& text, const QString& shortcut,
                              const QString& what) {
    auto* action = new QAction(text, this);
    action->setShortcut(QKeySequence(shortcut));
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    action->setToolTip(
        QStringLiteral("%1 (%2)").arg(what, action->shortcut().toString(QKeySequence::NativeText)));
    action->setStatusTip(what);
    connect(action, &QAction::triggered, this, [this, command] { run(command); });
    QWidget::addAction(action);
    m_actions[command] = action;
}

void LivePlotStack::run(Command command) {
    switch (command) {
    case Command::Pause:
        return setPaused(!isPaused());
    case Command::Fit:
        return fitAll();
    case Command::ZoomBack:
        return zoomBack();
    case Command::Follow:
    case Command::ShowAll:
    case Command::ZoomIn:
    case Command::ZoomOut:
    case Command::ScrollBack:
    case Command::ScrollOn:
    case Command::OwnTime:
    case Command::OneTimeAxis:
        return runOnTime(command);
    case Command::ZoomValuesIn:
    case Command::ZoomValuesOut:
    case Command::FitValues:
        return runOnValues(command);
    case Command::Marker:
    case Command::MarkerNote:
    case Command::NextMarker:
    case Command::PreviousMarker:
    case Command::RemoveMarker:
    case Command::ListMarkers:
        return runOnMarkers(command);
    case Command::PlotRight:
    case Command::PlotLeft:
    case Command::NewBeside:
    case Command::RemovePlot:
        return runOnPlots(command);
    case Command::Taller:
    case Command::Shorter:
    case Command::Wider:
    case Command::Narrower:
    case Command::EqualSizes:
        return runOnSizes(command);
    case Command::KeepReference:
        return keepReference();
    case Command::RemoveReference:
        return setReference(nullptr);
    case Command::AddSignals:
        Q_EMIT addSignalsRequested(activePlot());
        return;
    default:
        return runOnPairs(command);
    }
}

std::optional<int> LivePlotStack::focusedPlot() const {
    const auto focused = std::find_if(m_rows.begin(), m_rows.end(), [](const Row& row) {
        return row.plot->hasFocus() || row.legend->hasFocus();
    });
    return focused == m_rows.end() ? std::nullopt : std::optional(static_cast<int>(focused - m_rows.begin()));
}

void LivePlotStack::keyPressEvent(QKeyEvent* event) {
    const bool isValues = event->key() == Qt::Key_Up || event->key() == Qt::Key_Down;
    const bool isTime = event->key() == Qt::Key_Left || event->key() == Qt::Key_Right;
    const bool isControl = (event->modifiers() & (Qt::ControlModifier | Qt::AltModifier)) != 0;
    if (!isTime && (!isValues || isControl)) {
        QWidget::keyPressEvent(event);
        return;
    }
    const int sign = event->key() == Qt::Key_Right || event->key() == Qt::Key_Up ? 1 : -1;
    const bool isCoarse = (event->modifiers() & Qt::ShiftModifier) != 0;
    if (isValues) {
        return scrollValues(sign, isCoarse);
    }
    if (cursors().isVisible && (event->modifiers() & Qt::ControlModifier) == 0) {
        moveCursor(isCoarse ? sign * CoarseColumns : sign);
        return;
    }
    const bool wasFollowing = isFollowing();
    TimeView& view = activeView();
    view.pan(sign * (isCoarse ? 5.0 : 1.0) * Scroll_ratio * view.range().length_s());
    changed(wasFollowing, isPaused());
}

void LivePlotStack::setEvent(std::optional<double> event_s) {
    m_event_s = event_s;
    for (const Row& row : m_rows) {
        row.plot->setEvent(m_event_s);
    }
    m_isDirty = true;
}

void LivePlotStack::setLevel(const std::optional<PlotLevel>& level) {
    m_level = level;
    for (const Row& row : m_rows) {
        row.plot->setLevel(m_level);
    }
    m_isDirty = true;
}

} // namespace halbench::widgets
