// What the mouse does on a plot.
#include "widgets/live_plot/live_plot.h"

#include <QApplication>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMimeData>
#include <QMouseEvent>
#include <QWheelEvent>

#include <cmath>

namespace halbench::widgets {
namespace {

constexpr double CursorReach_px = 5.0; ///< of a level too
constexpr double ZoomPerStep = 1.25;
constexpr int StepsOfSpan = 1000;
constexpr int BesideShare = 6; ///< so large a part of the canvas, at its right edge
constexpr int StepAngle = 120; ///< of a wheel's notch, in Qt's eighths of a degree

double wheelSteps(const QWheelEvent& event) {
    const QPoint angle = event.angleDelta();
    return static_cast<double>(angle.y() != 0 ? angle.y() : angle.x()) / StepAngle;
}

} // namespace

bool LivePlot::eventFilter(QObject* watched, QEvent* event) {
    if (watched == canvas()) {
        switch (event->type()) {
        case QEvent::MouseButtonPress:
            press(*static_cast<QMouseEvent*>(event));
            return true;
        case QEvent::MouseMove:
            move(*static_cast<QMouseEvent*>(event));
            return true;
        case QEvent::MouseButtonRelease:
            release(*static_cast<QMouseEvent*>(event));
            return true;
        case QEvent::MouseButtonDblClick:
            Q_EMIT fitRequested();
            return true;
        case QEvent::Leave:
            setHoverPlace(std::nullopt);
            return false;
        case QEvent::Wheel:
            wheel(*static_cast<QWheelEvent*>(event));
            return true;
        default:
            break;
        }
    }
    return QwtPlot::eventFilter(watched, event);
}

/// The nearest within reach; of two at one place the one that the keyboard moves, and the pair that measures.
std::optional<LivePlot::Grip> LivePlot::cursorNear(double canvasX) const {
    std::optional<Grip> nearest;
    double nearest_px = CursorReach_px;
    const CursorPair measuring = m_cursors.cursors();
    for (std::size_t pair = 0; measuring.isVisible && pair < m_cursors.list().size(); ++pair) {
        for (int i = 0; i < 2; ++i) {
            const double away_px =
                std::abs(canvasMap(xBottom).transform(m_cursors.list()[pair].at(i)) - canvasX);
            const bool isPreferred = pair == m_cursors.chosen() && (i == measuring.active || !nearest ||
                                                                    nearest->pair != static_cast<int>(pair));
            if (away_px < nearest_px || (away_px == nearest_px && nearest && isPreferred)) {
                nearest_px = away_px;
                nearest = Grip{static_cast<int>(pair), i};
            }
        }
    }
    return nearest;
}

bool LivePlot::isLevelNear(double canvasY) const {
    const PlotCurve* curve = levelCurve();
    return curve != nullptr && std::abs(canvasMap(axisOf(*curve)).transform(curve->factor * m_level->level) -
                                        canvasY) < CursorReach_px;
}

void LivePlot::press(const QMouseEvent& event) {
    setFocus(Qt::MouseFocusReason);
    setHoverPlace(std::nullopt);
    m_pressed = event.pos();
    m_last = event.pos();
    const bool isPan = event.button() == Qt::MiddleButton ||
                       (event.button() == Qt::LeftButton && (event.modifiers() & Qt::ControlModifier) != 0);
    if (isPan) {
        m_drag = Drag::Pan;
        Q_EMIT viewAboutToChange();
        canvas()->setCursor(Qt::ClosedHandCursor);
    } else if (event.button() == Qt::LeftButton) {
        const std::optional<Grip> grip = cursorNear(event.pos().x());
        m_dragged = grip.value_or(Grip{});
        m_drag = grip ? Drag::Cursor : isLevelNear(event.pos().y()) ? Drag::Level : Drag::Box;
        if (grip && grip->pair != static_cast<int>(m_cursors.chosen())) {
            Q_EMIT pairPicked(grip->pair);
        }
    }
}

void LivePlot::move(const QMouseEvent& event) {
    switch (m_drag) {
    case Drag::None:
        canvas()->setCursor(cursorNear(event.pos().x())    ? Qt::SplitHCursor
                            : isLevelNear(event.pos().y()) ? Qt::SplitVCursor
                                                           : Qt::ArrowCursor);
        setHoverPlace(cursorNear(event.pos().x()) ? std::nullopt : std::optional(event.pos()));
        break;
    case Drag::Level:
        Q_EMIT levelMoved(canvasMap(axisOf(*levelCurve())).invTransform(event.pos().y()) /
                          levelCurve()->factor);
        break;
    case Drag::Cursor:
        Q_EMIT cursorMoved(m_dragged.index, timeAt(event.pos().x()));
        break;
    case Drag::Pan:
        panTo(event.pos());
        break;
    case Drag::Box:
        m_overlay->setBox(QRectF(m_pressed, event.pos()).normalized());
        replot();
        break;
    }
}

void LivePlot::setHoverPlace(std::optional<QPoint> place) {
    if (place != m_hoverPlace) {
        m_hoverPlace = place;
        replot();
    }
}

/// To a thousandth of what the axis shows.
std::optional<HoverReadout> LivePlot::readAtPointer() const {
    if (!m_hoverPlace || m_history == nullptr || m_curves.empty()) {
        return std::nullopt;
    }
    const QwtScaleMap map = canvasMap(xBottom);
    const int decimals = decimalsOf(niceStep(std::abs(map.s2() - map.s1()), StepsOfSpan));
    return hoverReadout(*m_hoverPlace, map.invTransform(m_hoverPlace->x()), m_event_s.value_or(0.0), decimals,
                        m_curves, *m_history);
}

void LivePlot::panTo(const QPoint& place) {
    Q_EMIT panRequested(timeAt(m_last.x()) - timeAt(place.x()));
    if (m_userRange) { // an axis that follows its data is left to do so
        const QwtScaleMap map = canvasMap(yLeft);
        const double by = map.invTransform(m_last.y()) - map.invTransform(place.y());
        zoomValues({m_userRange->low + by, m_userRange->high + by});
    }
    m_last = place;
}

void LivePlot::release(const QMouseEvent& event) {
    const Drag finished = m_drag;
    m_drag = Drag::None;
    canvas()->unsetCursor();
    if (finished == Drag::Box) {
        finishBox(event.pos());
    }
}

void LivePlot::finishBox(const QPoint& end) {
    const QRectF box = QRectF(m_pressed, end).normalized();
    m_overlay->setBox(std::nullopt);
    replot();
    if (box.width() < QApplication::startDragDistance() || box.height() < QApplication::startDragDistance()) {
        if (const auto marker = m_overlay->markerAt(end, canvasMap(xBottom), CursorReach_px)) {
            Q_EMIT markerPicked(static_cast<int>(*marker));
        }
        return; // a click
    }
    const QwtScaleMap map = canvasMap(yLeft);
    Q_EMIT boxChosen({timeAt(box.left()), timeAt(box.right())},
                     {map.invTransform(box.bottom()), map.invTransform(box.top())});
}

void LivePlot::wheel(const QWheelEvent& event) {
    const double factor = std::pow(ZoomPerStep, -wheelSteps(event));
    const QPointF place = event.position();
    if ((event.modifiers() & Qt::ControlModifier) == 0) {
        Q_EMIT zoomRequested(factor, timeAt(place.x()));
        return;
    }
    Q_EMIT viewAboutToChange();
    const ValueRange values = shownRange();
    const double at = canvasMap(yLeft).invTransform(place.y());
    zoomValues({at + factor * (values.low - at), at + factor * (values.high - at)});
    Q_EMIT valuesChanged();
}

void LivePlot::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasFormat(QLatin1String(SignalsMimeType))) {
        event->acceptProposedAction();
    }
}

/// Where a drop makes a plot beside this one, in coordinates of this widget: also beyond the canvas.
QRect LivePlot::besidePlace() const {
    const QRect canvas = canvasRect();
    const int left = canvas.right() - canvas.width() / BesideShare;
    return {left, 0, width() - left, height()};
}

/// On the canvas.
void LivePlot::showDropPlace(std::optional<QRectF> place) {
    m_overlay->setBox(place);
    replot();
}

void LivePlot::dragMoveEvent(QDragMoveEvent* event) {
    event->acceptProposedAction();
    const bool isBeside = besidePlace().contains(event->pos());
    showDropPlace(QRectF((isBeside ? besidePlace() : canvasRect())
                             .intersected(canvasRect())
                             .translated(-canvasRect().topLeft())));
}

void LivePlot::dragLeaveEvent(QDragLeaveEvent* event) {
    QwtPlot::dragLeaveEvent(event);
    showDropPlace(std::nullopt);
}

void LivePlot::dropEvent(QDropEvent* event) {
    showDropPlace(std::nullopt);
    const QByteArray names = event->mimeData()->data(QLatin1String(SignalsMimeType));
    const QStringList list = QString::fromUtf8(names).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    if (!list.isEmpty()) {
        event->acceptProposedAction();
        if (besidePlace().contains(event->pos())) {
            Q_EMIT signalsDroppedBeside(list);
        } else {
            Q_EMIT signalsDropped(list);
        }
    }
}

} // namespace halbench::widgets
