#include "widgets/live_plot/history_curve.h"

#include <QPainter>
#include <qwt_scale_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace halbench::widgets {
namespace {

constexpr double LineWidth = 1.5;
/// Samples farther apart than this are marked with dots.
constexpr double DotDistance_px = 6.0;
constexpr double DotDiameter_px = 4.0;

/// Dash pattern in pixels: ink, pause, ink, pause.
std::array<double, 4> dashesOf(LinePattern pattern) {
    switch (pattern) {
    case LinePattern::Dash:
        return {9.0, 5.0, 9.0, 5.0};
    case LinePattern::Dot:
        return {2.0, 4.0, 2.0, 4.0};
    case LinePattern::DashDot:
        return {9.0, 4.0, 2.0, 4.0};
    case LinePattern::Solid:
        break;
    }
    return {1.0, 0.0, 1.0, 0.0};
}

bool isInk(LinePattern pattern, double place_px) {
    const std::array<double, 4> dashes = dashesOf(pattern);
    const double period = dashes[0] + dashes[1] + dashes[2] + dashes[3];
    double place = std::fmod(place_px, period);
    place = place < 0.0 ? place + period : place;
    const double second = dashes[0] + dashes[1];
    return place < dashes[0] || (place >= second && place < second + dashes[2]);
}

PixelPoint middleOf(const PixelBox& box) {
    return {box.column + 0.5, 0.5 * (box.top + box.bottom)};
}

} // namespace

QPen curvePen(const QColor& colour, LinePattern pattern, double width) {
    QPen pen(colour, width);
    pen.setCapStyle(Qt::FlatCap);
    if (pattern != LinePattern::Solid) {
        QVector<qreal> dashes;
        for (const double length : dashesOf(pattern)) {
            dashes << length / width; // Qt counts in pen widths
        }
        pen.setDashPattern(dashes);
    }
    return pen;
}

HistoryCurve::HistoryCurve(PlotCurve curve, LinePattern pattern)
    : m_curve(std::move(curve)), m_pattern(pattern) {
    setZ(20.0);
}

void HistoryCurve::setSource(const control::SampleHistory* history, control::TimeRange drawn,
                             double shift_s) {
    m_history = history;
    m_drawn = {drawn.begin_s - shift_s, drawn.end_s - shift_s};
    m_shift_s = shift_s;
}

void HistoryCurve::draw(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap,
                        const QRectF& canvas) const {
    if (m_history == nullptr || m_curve.factor == 0.0) {
        return;
    }
    const double ratio = painter->device()->devicePixelRatioF();
    PixelMap map;
    map.columns = std::max(1, static_cast<int>(std::lround(canvas.width() * ratio)));
    map.rows = std::max(1, static_cast<int>(std::lround(canvas.height() * ratio)));
    map.perSecond = ratio * (xMap.p2() - xMap.p1()) / (xMap.s2() - xMap.s1());
    map.begin_s = xMap.invTransform(canvas.left()) - m_shift_s;
    const double perShown = ratio * (yMap.p2() - yMap.p1()) / (yMap.s2() - yMap.s1());
    map.perValue = m_curve.factor * perShown;
    map.zero = ratio * (yMap.p1() - canvas.top()) - perShown * yMap.s1() + 0.5;
    shapeCurve(*m_history, m_curve.signal, m_drawn, map, DotDistance_px * ratio, m_shape);
    auto* image = dynamic_cast<QImage*>(painter->device());
    if (image != nullptr && image->format() == QImage::Format_RGB32 && image->width() == map.columns) {
        rasterise(*image, map, ratio);
    } else {
        drawVectors(painter, canvas, ratio);
    }
}

void HistoryCurve::rasterise(QImage& image, const PixelMap& map, double ratio) const {
    const double width = LineWidth * ratio;
    m_mask.begin(map.columns, map.rows);
    for (std::size_t i = 0; i < m_shape.lineCount; ++i) {
        const std::vector<PixelPoint>& line = m_shape.lines[i];
        for (std::size_t point = 1; point < line.size(); ++point) {
            m_mask.addLine(line[point - 1], line[point], width);
        }
        for (const PixelPoint& point : line) { // a sample between two gaps would leave no trace
            if (m_shape.areSamplesMarked || line.size() == 1) {
                m_mask.addDot(point, DotDiameter_px * ratio);
            }
        }
    }
    const PixelBox* before = nullptr;
    for (const PixelBox& box : m_shape.boxes) {
        m_mask.addBox(box.column, box.top, box.bottom, width);
        if (box.isJoined && before->column + 1 < box.column) { // a slower stream's samples between fast ones
            m_mask.addLine(middleOf(*before), middleOf(box), width);
        }
        before = &box;
    }
    if (m_pattern == LinePattern::Solid) {
        m_mask.paint(image, m_colour, {});
        return;
    }
    const double firstColumn = std::round(map.begin_s * map.perSecond); // dashes travel with the data
    m_mask.paint(image, m_colour,
                 [&](int column) { return isInk(m_pattern, (firstColumn + column) / ratio); });
}

void HistoryCurve::drawVectors(QPainter* painter, const QRectF& canvas, double ratio) const {
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->translate(canvas.topLeft());
    painter->scale(1.0 / ratio, 1.0 / ratio);
    painter->setPen(curvePen(m_colour, m_pattern, LineWidth * ratio));
    painter->setBrush(Qt::NoBrush);
    for (std::size_t i = 0; i < m_shape.lineCount; ++i) {
        QPolygonF polygon;
        for (const PixelPoint& point : m_shape.lines[i]) {
            polygon << QPointF(point.x, point.y);
        }
        painter->drawPolyline(polygon);
    }
    QPolygonF polygon;
    for (const PixelBox& box : m_shape.boxes) {
        if (!box.isJoined) {
            painter->drawPolyline(polygon);
            polygon.clear();
        }
        polygon << QPointF(box.column + 0.5, box.top) << QPointF(box.column + 0.5, box.bottom);
    }
    painter->drawPolyline(polygon);
    painter->restore();
}

} // namespace halbench::widgets
