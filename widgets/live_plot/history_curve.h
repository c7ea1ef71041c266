#pragma once

#include "control/history/sample_history.h"
#include "widgets/live_plot/live_plot_spec.h"
#include "widgets/raster/curve_mask.h"
#include "widgets/raster/curve_shape.h"

#include <QColor>
#include <QRect>
#include <qwt_plot_item.h>

#include <vector>

namespace halbench::widgets {

/// Pattern of a curve's line: the second eight curves of a plot are dashed, the next dotted, then both.
enum class LinePattern { Solid, Dash, Dot, DashDot };

/// Colours of curves in a theme. A place among the looks of curves counts colours first, then patterns:
/// 0 ... 31.
inline constexpr int CurveColours = 8;
inline constexpr int LinePatterns = 4;

inline LinePattern patternAt(int place) {
    return static_cast<LinePattern>(place / CurveColours % LinePatterns);
}

/// With the colour of a place.
inline int placeWith(int colour, LinePattern pattern) {
    return static_cast<int>(pattern) * CurveColours + colour % CurveColours;
}

/// Draws one signal straight from the history in device pixels, so that a frame costs pixels and not samples.
/// On an RGB32 image of the canvas' size, which is what a live plot paints on, it sets the pixels itself; on
/// anything else (an export) it draws lines.
class HistoryCurve : public QwtPlotItem {
public:
    HistoryCurve(PlotCurve curve, LinePattern pattern);

    const PlotCurve& curve() const { return m_curve; }
    LinePattern pattern() const { return m_pattern; }
    void setPattern(LinePattern pattern) { m_pattern = pattern; }
    void setOwnName(const QString& name) { m_curve.ownName = name; }
    const QColor& colour() const { return m_colour; }
    void setColour(const QColor& colour) { m_colour = colour; }
    /// Not owned; may be null. `drawn`, of the axis: nothing outside is shown although the axis may be
    /// longer. `shift_s`: so much later than its time a sample is drawn.
    void setSource(const control::SampleHistory* history, control::TimeRange drawn, double shift_s = 0.0);

    void draw(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap,
              const QRectF& canvas) const override;

private:
    void rasterise(QImage& image, const PixelMap& map, double ratio) const;
    void drawVectors(QPainter* painter, const QRectF& canvas, double ratio) const;

    PlotCurve m_curve;
    LinePattern m_pattern;
    QColor m_colour;
    const control::SampleHistory* m_history = nullptr;
    control::TimeRange m_drawn; ///< in the history's time
    double m_shift_s = 0.0;
    mutable CurveShape m_shape; ///< kept, so that frames do not allocate
    mutable CurveMask m_mask;
};

/// The pen of a curve and of its sample in the legend.
QPen curvePen(const QColor& colour, LinePattern pattern, double width);

} // namespace halbench::widgets
