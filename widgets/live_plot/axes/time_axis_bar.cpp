#include "widgets/live_plot/axes/time_axis_bar.h"

#include "widgets/live_plot/axes/value_range.h"
#include "widgets/live_plot/axes/value_scale_draw.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPalette>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace halbench::widgets {
namespace {

constexpr double ZoomPerStep = 1.25;
constexpr int StepAngle = 120; ///< of a wheel's notch, in Qt's eighths of a degree
constexpr int StateGap = 12;   ///< between what is said of the axis and its title

} // namespace

TimeAxisBar::TimeAxisBar(QWidget* parent) : QWidget(parent), m_scale(std::make_unique<ValueScaleDraw>()) {
    m_scale->setAlignment(QwtScaleDraw::BottomScale);
    setFixedHeight(2 * fontMetrics().height() + 10);
    setAccessibleName(tr("Time axis"));
    setCursor(Qt::SizeHorCursor);
}

TimeAxisBar::~TimeAxisBar() = default;

void TimeAxisBar::setTheme(const Theme& theme) {
    m_theme = theme;
    update();
}

void TimeAxisBar::setCanvas(int left, int width) {
    if (left != m_left || width != m_width) {
        m_left = left;
        m_width = width;
        update();
    }
}

void TimeAxisBar::setRange(control::TimeRange range, double step_s, std::optional<double> origin_s) {
    m_scale->setDecimals(decimalsOf(step_s));
    const double zero_s = origin_s.value_or(0.0);
    m_isFromEvent = origin_s.has_value();
    m_range = range;
    m_scale->setScaleDiv(divisionOf(range.begin_s - zero_s, range.end_s - zero_s, step_s));
    update();
}

void TimeAxisBar::setState(const QString& state, bool isWarning) {
    if (state != m_state || isWarning != m_isWarning) {
        m_state = state;
        m_isWarning = isWarning;
        setAccessibleDescription(state);
        update();
    }
}

void TimeAxisBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), m_theme.panel);
    m_scale->move(m_left, 0.0);
    m_scale->setLength(std::max(1, m_width - 1));
    QPalette colours = palette();
    colours.setColor(QPalette::WindowText, m_theme.plotAxis);
    colours.setColor(QPalette::Text, m_theme.plotAxis);
    painter.setFont(font());
    m_scale->draw(&painter, colours);
    const int top = height() - fontMetrics().height() - 2;
    const QRect line(m_left, top, std::max(0, width() - m_left), fontMetrics().height());
    painter.setPen(m_isWarning ? m_theme.warn : m_theme.muted);
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, shownState());
    painter.setPen(m_theme.text);
    painter.drawText(line.adjusted(titleLeft() - m_left, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, title());
}

double TimeAxisBar::timeAt(double x_px) const {
    return m_range.begin_s + m_range.length_s() * (x_px - m_left) / std::max(1, m_width - 1);
}

void TimeAxisBar::wheelEvent(QWheelEvent* event) {
    const double steps = static_cast<double>(event->angleDelta().y()) / StepAngle;
    Q_EMIT zoomRequested(std::pow(ZoomPerStep, -steps), timeAt(event->position().x()));
    event->accept();
}

void TimeAxisBar::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) {
        m_last_px = event->localPos().x();
    }
}

void TimeAxisBar::mouseMoveEvent(QMouseEvent* event) {
    if (m_last_px && event->localPos().x() != *m_last_px) {
        const double by_s = timeAt(*m_last_px) - timeAt(event->localPos().x());
        m_last_px = event->localPos().x();
        Q_EMIT panRequested(by_s);
    }
}

void TimeAxisBar::mouseReleaseEvent(QMouseEvent*) {
    m_last_px.reset();
}

void TimeAxisBar::mouseDoubleClickEvent(QMouseEvent*) {
    m_last_px.reset();
    Q_EMIT fitRequested();
}

QString TimeAxisBar::title() const {
    return m_isFromEvent ? tr("time relative to the event [s]") : tr("time [s]");
}

/// Below the middle of the canvases, but never on the state, and never beyond the edge.
int TimeAxisBar::titleLeft() const {
    const int title_px = fontMetrics().horizontalAdvance(title());
    const int middle = m_left + (m_width - title_px) / 2;
    const int afterState = m_left + fontMetrics().horizontalAdvance(m_state) + StateGap;
    return std::min(std::max(middle, afterState), width() - title_px);
}

QString TimeAxisBar::shownState() const {
    const int room_px = titleLeft() - m_left - StateGap;
    return fontMetrics().horizontalAdvance(m_state) <= room_px // which eliding measures in other fractions
               ? m_state
               : fontMetrics().elidedText(m_state, Qt::ElideRight, room_px);
}

} // namespace halbench::widgets
