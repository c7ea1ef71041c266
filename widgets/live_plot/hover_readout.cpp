#include "widgets/live_plot/hover_readout.h"

#include "widgets/language/display_units.h"
#include "widgets/live_plot/legend_table_model.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace halbench::widgets {
namespace {

constexpr double Distance_px = 12.0; ///< from the pointer
constexpr double Margin_px = 5.0;
constexpr double Swatch_px = 10.0;

QString valueText(const HistoryCurve& curve, const control::SampleHistory& history, double time_s) {
    const PlotCurve& shown = curve.curve();
    const auto sample = history.valueAt(shown.signal, time_s);
    const auto value = sample ? std::optional(shown.factor * sample->value) : std::nullopt;
    return QStringLiteral("%1 %2 %3").arg(curveWords(shown), fixedText(value, shown.decimals), shown.unit);
}

/// At the right of the pointer and below it; on the other side where the canvas ends.
QRectF boxAt(const QPointF& place, const QSizeF& size, const QRectF& canvas) {
    const bool isLeft = place.x() + Distance_px + size.width() > canvas.right();
    const bool isAbove = place.y() + Distance_px + size.height() > canvas.bottom();
    const double x = isLeft ? place.x() - Distance_px - size.width() : place.x() + Distance_px;
    const double y = isAbove ? place.y() - Distance_px - size.height() : place.y() + Distance_px;
    return {{std::max(canvas.left(), x), std::max(canvas.top(), y)}, size};
}

} // namespace

HoverReadout hoverReadout(const QPointF& place, double time_s, double origin_s, int decimals,
                          const std::vector<HistoryCurve*>& curves, const control::SampleHistory& history) {
    HoverReadout hover{place, {}};
    hover.lines.push_back({QColor(), QStringLiteral("%1 s").arg(fixedText(time_s - origin_s, decimals))});
    for (const HistoryCurve* curve : curves) {
        if (curve->isVisible()) {
            hover.lines.push_back({curve->colour(), valueText(*curve, history, time_s)});
        }
    }
    return hover;
}

void drawHover(QPainter& painter, const HoverReadout& hover, const QRectF& canvas, const Theme& theme) {
    const QFontMetricsF metrics(painter.font());
    double width = 0.0;
    for (const HoverReadout::Line& line : hover.lines) {
        const double swatch = line.colour.isValid() ? Swatch_px + Margin_px : 0.0;
        width = std::max(width, swatch + metrics.horizontalAdvance(line.text));
    }
    const double height = metrics.height() * static_cast<double>(hover.lines.size());
    const QRectF box =
        boxAt(hover.place, {std::ceil(width) + 2.0 * Margin_px, std::ceil(height) + 2.0 * Margin_px}, canvas);
    painter.fillRect(QRectF(std::round(hover.place.x()), canvas.top(), 1.0, canvas.height()), theme.muted);
    painter.setPen(QPen(theme.line, 1.0));
    painter.setBrush(theme.panel);
    painter.drawRect(box);
    double top = box.top() + Margin_px;
    for (const HoverReadout::Line& line : hover.lines) {
        double left = box.left() + Margin_px;
        if (line.colour.isValid()) {
            painter.fillRect(QRectF(left, top + 0.5 * metrics.height() - 1.0, Swatch_px, 2.0), line.colour);
            left += Swatch_px + Margin_px;
        }
        painter.setPen(line.colour.isValid() ? theme.text : theme.muted);
        painter.drawText(QPointF(left, top + metrics.ascent()), line.text);
        top += metrics.height();
    }
}

} // namespace halbench::widgets
