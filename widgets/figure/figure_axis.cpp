#include "widgets/figure/figure_axis.h"

#include "control/base/unit_text.h"
#include "widgets/figure/figure_painter.h"
#include "widgets/language/display_units.h"

#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <qwt_text.h>
#include <qwt_transform.h>

#include <algorithm>
#include <cmath>

namespace halbench::widgets {
namespace {

int decimalsFor(const FigureScale& scale) {
    const QList<double> ticks = scale.division.ticks(QwtScaleDiv::MajorTick);
    if (scale.isLogarithmic || ticks.size() < 2) {
        return -1;
    }
    const double step = std::abs(ticks[1] - ticks[0]);
    const double largest = std::max(std::abs(ticks.first()), std::abs(ticks.last()));
    // Steps are 1, 2 or 5 times a power of ten, or whole numbers such as 45.
    const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
    return decimals > 9 || largest < 1e-4 || largest >= 1e7 ? -1 : decimals;
}

QString titleOf(const Axis& axis) {
    const QString quantity = QString::fromStdString(axis.quantity);
    return axis.unit.empty() ? quantity
                             : QStringLiteral("%1 [%2]")
                                   .arg(quantity, QString::fromStdString(unitText(axis.unit)))
                                   .trimmed();
}

} // namespace

FigureAxis::FigureAxis(const FigureScale& scale, Alignment alignment, const QRectF& canvas)
    : m_decimals(decimalsFor(scale)) {
    const bool isVertical = alignment == LeftScale || alignment == RightScale;
    setAlignment(alignment);
    if (scale.isLogarithmic) {
        setTransformation(new QwtLogTransform); // owned by the scale
    }
    setScaleDiv(scale.division);
    enableComponent(Backbone, false);
    setTickLength(QwtScaleDiv::MinorTick, 2.0);
    setTickLength(QwtScaleDiv::MediumTick, 2.0);
    setTickLength(QwtScaleDiv::MajorTick, 5.0);
    move(alignment == LeftScale    ? canvas.topLeft()
         : alignment == RightScale ? canvas.topRight()
                                   : canvas.bottomLeft());
    setLength(isVertical ? canvas.height() : canvas.width());
}

QwtText FigureAxis::label(double value) const {
    const double unit = m_decimals < 0 ? 0.0 : std::pow(10.0, -m_decimals);
    const double shown = std::abs(value) < 0.5 * unit ? 0.0 : value; // never "-0.0"
    QString number = m_decimals < 0 ? tidyExponent(QLocale::c().toString(value, 'g', 6))
                                    : QLocale::c().toString(shown, 'f', m_decimals);
    return number.replace(QLatin1Char('.'), m_decimalPoint);
}

void drawVerticalTitle(QPainter& painter, const Axis& axis, double baseline_px, const QRectF& canvas,
                       const Theme& theme) {
    painter.save();
    painter.setFont(figureFont());
    painter.setPen(theme.text);
    painter.translate(baseline_px, canvas.center().y());
    painter.rotate(-90.0);
    const QString title = titleOf(axis);
    painter.drawText(QPointF(-0.5 * QFontMetricsF(figureFont()).horizontalAdvance(title), 0.0), title);
    painter.restore();
}

void drawHorizontalTitle(QPainter& painter, const Axis& axis, const QRectF& canvas, const Theme& theme) {
    painter.setFont(figureFont());
    painter.setPen(theme.text);
    const QString title = titleOf(axis);
    const double width_px = QFontMetricsF(figureFont()).horizontalAdvance(title);
    painter.drawText(QPointF(canvas.center().x() - 0.5 * width_px, canvas.bottom() + 36.0), title);
}

} // namespace halbench::widgets
