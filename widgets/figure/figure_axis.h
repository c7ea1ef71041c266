#pragma once

#include "widgets/figure/figure_scales.h"
#include "widgets/theme/theme.h"

#include <qwt_scale_draw.h>

class QPainter;

namespace halbench::widgets {

/// Ticks and labels of one side of a panel. All labels of an axis have the same number of decimals, as many
/// as the distance of the ticks needs.
class FigureAxis : public QwtScaleDraw {
public:
    FigureAxis(const FigureScale& scale, Alignment alignment, const QRectF& canvas);

    void setDecimalPoint(QChar point) { m_decimalPoint = point; }
    QwtText label(double value) const override;

private:
    QChar m_decimalPoint = QLatin1Char('.');
    int m_decimals = -1; ///< negative: shortest notation, for logarithmic, very small and very large scales
};

/// Titles of axes: upright with its baseline at this column, in the middle of the canvas; and below it.
void drawVerticalTitle(QPainter& painter, const Axis& axis, double baseline_px, const QRectF& canvas,
                       const Theme& theme);
void drawHorizontalTitle(QPainter& painter, const Axis& axis, const QRectF& canvas, const Theme& theme);

} // namespace halbench::widgets
