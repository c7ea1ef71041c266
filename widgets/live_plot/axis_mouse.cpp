#include "widgets/live_plot/axis_mouse.h"

#include "widgets/live_plot/live_plot.h"

#include <QMouseEvent>
#include <QWheelEvent>
#include <qwt_scale_widget.h>

#include <cmath>

namespace halbench::widgets {
namespace {

constexpr double ZoomPerStep = 1.25;
constexpr int StepAngle = 120; ///< of a wheel's notch, in Qt's eighths of a degree

} // namespace

AxisMouse::AxisMouse(LivePlot& plot, bool isRight) : QObject(&plot), m_plot(plot), m_isRight(isRight) {
    QwtScaleWidget* axis = plot.axisWidget(isRight ? QwtPlot::yRight : QwtPlot::yLeft);
    axis->setCursor(Qt::SizeVerCursor);
    axis->installEventFilter(this);
}

bool AxisMouse::eventFilter(QObject*, QEvent* event) {
    switch (event->type()) {
    case QEvent::Wheel:
        wheel(*static_cast<QWheelEvent*>(event));
        return true;
    case QEvent::MouseButtonPress:
        press(*static_cast<QMouseEvent*>(event));
        return true;
    case QEvent::MouseMove:
        move(*static_cast<QMouseEvent*>(event));
        return true;
    case QEvent::MouseButtonRelease:
        m_last_px.reset();
        return true;
    case QEvent::MouseButtonDblClick:
        followData();
        return true;
    default:
        return false;
    }
}

/// Axis and canvas begin at different heights.
double AxisMouse::valueAt(int y_px) const {
    const int axis = m_isRight ? QwtPlot::yRight : QwtPlot::yLeft;
    const int canvas_px =
        m_plot.axisWidget(axis)->mapTo(&m_plot, QPoint(0, y_px)).y() - m_plot.canvasRect().top();
    return m_plot.canvasMap(axis).invTransform(canvas_px);
}

void AxisMouse::hold(const ValueRange& range) {
    HeldRanges held = m_plot.heldRanges();
    (m_isRight ? held.right : held.left) = range;
    m_plot.setHeldRanges(held);
    Q_EMIT m_plot.valuesChanged();
}

void AxisMouse::wheel(const QWheelEvent& event) {
    const double steps = static_cast<double>(event.angleDelta().y()) / StepAngle;
    const double factor = std::pow(ZoomPerStep, -steps);
    const ValueRange shown = m_plot.shownRange(m_isRight);
    const double at = valueAt(event.position().toPoint().y());
    Q_EMIT m_plot.viewAboutToChange();
    hold({at + factor * (shown.low - at), at + factor * (shown.high - at)});
}

void AxisMouse::press(const QMouseEvent& event) {
    m_plot.setFocus(Qt::MouseFocusReason);
    if (event.button() == Qt::LeftButton) {
        m_last_px = event.pos().y();
        m_isMoved = false;
    }
}

void AxisMouse::move(const QMouseEvent& event) {
    if (!m_last_px || event.pos().y() == *m_last_px) {
        return;
    }
    if (!m_isMoved) {
        m_isMoved = true;
        Q_EMIT m_plot.viewAboutToChange();
    }
    const double by = valueAt(*m_last_px) - valueAt(event.pos().y());
    const ValueRange shown = m_plot.shownRange(m_isRight);
    m_last_px = event.pos().y();
    hold({shown.low + by, shown.high + by});
}

void AxisMouse::followData() {
    m_last_px.reset();
    Q_EMIT m_plot.viewAboutToChange();
    HeldRanges other = m_plot.heldRanges();
    (m_isRight ? other.right : other.left).reset();
    m_plot.fitValues(); // at once, both
    m_plot.setHeldRanges(other);
    Q_EMIT m_plot.valuesChanged();
}

} // namespace halbench::widgets
