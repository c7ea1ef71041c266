#include "widgets/actuators/htm/hall_trace_view.h"

#include "widgets/language/display_units.h"
#include "widgets/theme/theme_style.h"

#include <QEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace halbench::widgets {

namespace {

constexpr double Circle_T = 0.05;    ///< between two circles of the scale
constexpr double LeastScale_T = 0.2; ///< of the motor's own field, 0.16 T, with room
constexpr double MostCircles = 8.0;
constexpr double mTPerT = 1e3;
constexpr double Dot_px = 1.5;

/// Whole circles of a size with at most eight of them.
double circleFor(double fullScale_T) {
    double circle_T = Circle_T;
    while (fullScale_T / circle_T > MostCircles) {
        circle_T *= 2.0;
    }
    return circle_T;
}

} // namespace

HallTraceView::HallTraceView(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    describe();
}

void HallTraceView::add(double angle_rad, double hall_a_T, double hall_b_T) {
    if (!std::isfinite(angle_rad) || !std::isfinite(hall_a_T) || !std::isfinite(hall_b_T)) {
        return;
    }
    const double turns = angle_rad / (2.0 * std::numbers::pi);
    const auto count = static_cast<double>(m_readings_T.size());
    const auto bin = static_cast<std::size_t>((turns - std::floor(turns)) * count) % m_readings_T.size();
    m_newest_T = QPointF(hall_a_T, hall_b_T);
    m_readings_T[bin] = m_newest_T;
    m_largest_T = std::max(m_largest_T, std::hypot(hall_a_T, hall_b_T));
    update();
}

void HallTraceView::setStale(bool isStale) {
    m_isStale = isStale;
    update();
}

void HallTraceView::clear() {
    m_readings_T.fill(std::nullopt);
    m_newest_T.reset();
    m_largest_T = 0.0;
    update();
}

int HallTraceView::angles() const {
    return static_cast<int>(std::count_if(m_readings_T.begin(), m_readings_T.end(),
                                          [](const auto& one) { return one.has_value(); }));
}

double HallTraceView::fullScale_T() const {
    const double wanted_T = std::max(LeastScale_T, m_largest_T);
    const double circle_T = circleFor(wanted_T);
    return circle_T * std::ceil(wanted_T / circle_T);
}

void HallTraceView::paintEvent(QPaintEvent*) {
    const Theme theme = currentTheme();
    QPainter painter(this);
    painter.fillRect(rect(), theme.plotBackground);
    painter.setRenderHint(QPainter::Antialiasing);
    const double title_px = painter.fontMetrics().height() + 2.0 * PanelMargin_px;
    const double radius_px = std::min(width() / 2.0 - PanelMargin_px, height() / 2.0 - title_px);
    const double pixels_per_T = std::max(1.0, radius_px) / fullScale_T();
    painter.translate(width() / 2.0, height() / 2.0);
    drawScale(painter, pixels_per_T);
    drawReadings(painter, pixels_per_T);
    drawTitles(painter, pixels_per_T);
}

void HallTraceView::drawScale(QPainter& painter, double pixels_per_T) const {
    const Theme theme = currentTheme();
    const double full_px = fullScale_T() * pixels_per_T;
    const double circle_T = circleFor(fullScale_T());
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme.plotGrid, 1.0));
    painter.drawLine(QPointF(-full_px, 0.0), QPointF(full_px, 0.0));
    painter.drawLine(QPointF(0.0, -full_px), QPointF(0.0, full_px));
    painter.setFont(tabularFont(font()));
    for (double at_T = circle_T; at_T < fullScale_T() + circle_T / 2.0; at_T += circle_T) {
        const double radius_px = at_T * pixels_per_T;
        painter.setPen(QPen(theme.plotGrid, 1.0));
        painter.drawEllipse(QPointF(), radius_px, radius_px);
        painter.setPen(theme.muted);
        const double half_px = radius_px * std::numbers::sqrt2 / 2.0; // numbers stand on the diagonal
        painter.drawText(QPointF(half_px + 2.0, half_px - 2.0),
                         fixedText(at_T * mTPerT, 0) + QStringLiteral(" mT"));
    }
}

void HallTraceView::drawReadings(QPainter& painter, double pixels_per_T) const {
    const Theme theme = currentTheme();
    const auto place = [&](const QPointF& reading_T) {
        return QPointF(reading_T.x() * pixels_per_T, -reading_T.y() * pixels_per_T);
    };
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_isStale ? theme.muted : theme.curves[2]);
    for (const std::optional<QPointF>& reading_T : m_readings_T) {
        if (reading_T) {
            painter.drawEllipse(place(*reading_T), Dot_px, Dot_px);
        }
    }
    if (m_newest_T) {
        const QColor ink = m_isStale ? theme.muted : theme.accent;
        painter.setPen(QPen(ink, 1.5));
        painter.drawLine(QPointF(), place(*m_newest_T));
        painter.setBrush(ink);
        painter.drawEllipse(place(*m_newest_T), 2.0 * Dot_px, 2.0 * Dot_px);
    }
}

void HallTraceView::drawTitles(QPainter& painter, double pixels_per_T) const {
    const Theme theme = currentTheme();
    const double full_px = fullScale_T() * pixels_per_T;
    const double line_px = painter.fontMetrics().height();
    painter.setFont(font());
    painter.setPen(theme.text);
    painter.drawText(QRectF(-width() / 2.0, -height() / 2.0 + PanelMargin_px, width(), line_px),
                     Qt::AlignHCenter | Qt::AlignTop, tr("Hall readings over a turn"));
    painter.setPen(theme.curves[3]);
    painter.drawText(QRectF(0.0, -line_px - 2.0, full_px - 4.0, line_px), Qt::AlignRight | Qt::AlignBottom,
                     tr("Hall A"));
    painter.setPen(theme.curves[5]);
    painter.drawText(QRectF(6.0, -full_px + 2.0, full_px, line_px), Qt::AlignLeft | Qt::AlignTop,
                     tr("Hall B"));
}

void HallTraceView::describe() {
    setAccessibleName(tr("Hall readings over a turn"));
    setToolTip(tr("Hall B over Hall A, the newest reading at each angle"));
}

void HallTraceView::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        describe();
    }
    update();
}

} // namespace halbench::widgets
