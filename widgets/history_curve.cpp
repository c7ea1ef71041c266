#include "widgets/history_curve.h"

#include <QPainter>
#include <qwt_scale_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace halbench::widgets {
namespace {

constexpr double LineWidth = 1.5;
/// Up to so many samples a column the line through the samples is drawn.
constexpr double SparseSamples_ratio = 1.0;
/// Samples farther apart than this are marked with dots.
constexpr double DotDistance_px = 6.0;
constexpr double DotDiameter_px = 4.0;
/// An antialiased line of many points at once is slow; pieces of this many are not.
constexpr int PiecePoints = 16;

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

/// Device pixels from the left and top edge of the canvas; pixel i's centre is at i.
struct HistoryCurve::Pixels {
    Pixels(const QwtScaleMap& xMap, const QwtScaleMap& yMap, const QRectF& canvas, double deviceRatio,
           double factor)
        : ratio(deviceRatio), columns(std::max(1, static_cast<int>(std::lround(canvas.width() * ratio)))),
          perSecond(ratio * (xMap.p2() - xMap.p1()) / (xMap.s2() - xMap.s1())),
          begin_s(xMap.invTransform(canvas.left())),
          perValue(factor * ratio * (yMap.p2() - yMap.p1()) / (yMap.s2() - yMap.s1())),
          zero(ratio * (yMap.p1() - canvas.top()) - perValue / factor * yMap.s1()) {}

    double x(double time_s) const { return (time_s - begin_s) * perSecond; }
    double y(double value) const { // far outside is as good as outside, and safe as an integer
        return std::clamp(zero + perValue * value, -1e4, 1e5);
    }
    double timeAt(double column) const { return begin_s + column / perSecond; }

    double ratio;
    int columns;
    double perSecond;
    double begin_s;
    double perValue;
    double zero;
};

HistoryCurve::HistoryCurve(PlotCurve curve, LinePattern pattern)
    : m_curve(std::move(curve)), m_pattern(pattern) {
    setZ(20.0);
}

void HistoryCurve::setSource(const control::SampleHistory* history, control::TimeRange drawn) {
    m_history = history;
    m_drawn = drawn;
}

void HistoryCurve::draw(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap,
                        const QRectF& canvas) const {
    if (m_history == nullptr || m_curve.factor == 0.0) {
        return;
    }
    const double ratio = painter->device()->devicePixelRatioF();
    const Pixels pixels(xMap, yMap, canvas, ratio, m_curve.factor);
    painter->save();
    painter->translate(canvas.topLeft());
    painter->scale(1.0 / ratio, 1.0 / ratio);
    const auto rows = static_cast<double>(m_history->rowsIn(m_curve.signal, m_drawn));
    if (rows <= SparseSamples_ratio * pixels.columns) {
        drawSamples(painter, pixels);
    } else {
        drawColumns(painter, pixels);
    }
    painter->restore();
}

void HistoryCurve::drawSamples(QPainter* painter, const Pixels& pixels) const {
    m_history->samples(m_curve.signal, m_drawn, m_samples);
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(curvePen(m_colour, m_pattern, LineWidth * pixels.ratio));
    painter->setBrush(Qt::NoBrush);
    QVector<QPointF> points;
    QVector<QPointF> lonely; // a sample between two gaps would leave no trace
    const auto flush = [&](bool isEnd) {
        if (points.size() > 1) {
            painter->drawPolyline(points.constData(), points.size());
        } else if (isEnd && points.size() == 1) {
            lonely << points.front();
        }
        points = isEnd ? QVector<QPointF>() : QVector<QPointF>{points.back()};
    };
    const int piece = m_pattern == LinePattern::Solid ? PiecePoints : 4096; // dashes run on in a piece
    for (const control::TimedValue& sample : m_samples) {
        if (sample.isAfterGap || std::isnan(sample.value)) {
            flush(true);
        }
        if (!std::isnan(sample.value) && sample.time_s <= m_drawn.end_s + 0.5 * m_drawn.length_s()) {
            points << QPointF(pixels.x(sample.time_s) + 0.5, pixels.y(sample.value) + 0.5);
        }
        if (points.size() >= piece) {
            flush(false);
        }
    }
    flush(true);
    const double distance_px = static_cast<double>(pixels.columns) / pixels.ratio /
                               static_cast<double>(std::max<std::size_t>(m_samples.size(), 1));
    painter->setPen(Qt::NoPen);
    painter->setBrush(m_colour);
    const double radius = 0.5 * DotDiameter_px * pixels.ratio;
    for (const QPointF& point : lonely) {
        painter->drawEllipse(point, radius, radius);
    }
    for (const control::TimedValue& sample : m_samples) {
        if (distance_px > DotDistance_px && !std::isnan(sample.value)) {
            painter->drawEllipse(QPointF(pixels.x(sample.time_s) + 0.5, pixels.y(sample.value) + 0.5), radius,
                                 radius);
        }
    }
}

bool HistoryCurve::isInk(double column, double ratio) const {
    const std::array<double, 4> dashes = dashesOf(m_pattern);
    const double period = ratio * (dashes[0] + dashes[1] + dashes[2] + dashes[3]);
    double place = std::fmod(column, period);
    place = place < 0.0 ? place + period : place;
    return place < ratio * dashes[0] ||
           (place >= ratio * (dashes[0] + dashes[1]) && place < ratio * (dashes[0] + dashes[1] + dashes[2]));
}

void HistoryCurve::drawColumns(QPainter* painter, const Pixels& pixels) const {
    const control::TimeRange range{pixels.timeAt(-0.5),
                                   std::min(pixels.timeAt(pixels.columns - 0.5), m_drawn.end_s)};
    const int count = std::clamp(
        static_cast<int>(std::ceil((range.end_s - range.begin_s) * pixels.perSecond)), 1, pixels.columns);
    m_history->columns(m_curve.signal, {range.begin_s, pixels.timeAt(count - 0.5)},
                       static_cast<std::size_t>(count), m_columns);
    m_ink.clear();
    const int thickness = static_cast<int>(std::lround(LineWidth * pixels.ratio));
    const double firstColumn = std::round(pixels.begin_s * pixels.perSecond);
    int before = -1; // column of the last ink
    int top = 0;
    int bottom = 0;
    for (int i = 0; i < count; ++i) {
        const control::HistoryColumn& column = m_columns[static_cast<std::size_t>(i)];
        if (column.extremes.isEmpty()) {
            continue;
        }
        const double first = pixels.y(column.extremes.max);
        const double second = pixels.y(column.extremes.min);
        int newTop = static_cast<int>(std::lround(std::min(first, second)));
        int newBottom = static_cast<int>(std::lround(std::max(first, second)));
        const int ownTop = newTop;
        const int ownBottom = newBottom;
        if (before >= 0 && !column.isAfterGap) { // half of the way each, so that the line stays connected
            const int middle = newTop > bottom ? (bottom + newTop) / 2 : (top + newBottom) / 2;
            if (newTop > bottom || newBottom < top) {
                newTop = std::min(newTop, middle);
                newBottom = std::max(newBottom, middle);
                if (!m_ink.empty() && m_ink.back().left() == i - 1) {
                    m_ink.back().setTop(std::min(m_ink.back().top(), middle));
                    m_ink.back().setBottom(std::max(m_ink.back().bottom(), middle));
                }
            }
        }
        const int missing = std::max(0, thickness - (newBottom - newTop + 1));
        if (m_pattern == LinePattern::Solid || isInk(firstColumn + i, pixels.ratio)) {
            m_ink.emplace_back(QPoint(i, newTop - missing / 2), QPoint(i, newBottom + (missing + 1) / 2));
        }
        before = i;
        top = ownTop;
        bottom = ownBottom;
    }
    painter->setRenderHint(QPainter::Antialiasing, false);
    painter->setPen(Qt::NoPen);
    painter->setBrush(m_colour);
    painter->drawRects(m_ink.data(), static_cast<int>(m_ink.size()));
}

} // namespace halbench::widgets
