#pragma once

#include "control/signals/sample_history.h"
#include "widgets/live_plot_spec.h"

#include <QColor>
#include <QRect>
#include <qwt_plot_item.h>

#include <vector>

namespace halbench::widgets {

/// Pattern of a curve's line: the second eight curves of a plot are dashed, the next dotted, then both.
enum class LinePattern { Solid, Dash, Dot, DashDot };

/// Draws one signal straight from the history in device pixels: an antialiased line through the samples where
/// they are sparse, else the extremes of each pixel column, so that a frame costs pixels and not samples.
/// A sample belongs to the column whose centre is nearest. Gaps and breaks interrupt the line.
class HistoryCurve : public QwtPlotItem {
public:
    HistoryCurve(PlotCurve curve, LinePattern pattern);

    const PlotCurve& curve() const { return m_curve; }
    LinePattern pattern() const { return m_pattern; }
    const QColor& colour() const { return m_colour; }
    void setColour(const QColor& colour) { m_colour = colour; }
    /// Not owned; may be null. `drawn`: nothing outside is shown although the axis may be longer.
    void setSource(const control::SampleHistory* history, control::TimeRange drawn);

    void draw(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap,
              const QRectF& canvas) const override;

private:
    struct Pixels; ///< maps time and value to device pixels of one frame
    void drawSamples(QPainter* painter, const Pixels& pixels) const;
    void drawColumns(QPainter* painter, const Pixels& pixels) const;
    bool isInk(double column, double ratio) const;

    PlotCurve m_curve;
    LinePattern m_pattern;
    QColor m_colour;
    const control::SampleHistory* m_history = nullptr;
    control::TimeRange m_drawn;
    mutable std::vector<control::HistoryColumn> m_columns; ///< kept, so that frames do not allocate
    mutable std::vector<control::TimedValue> m_samples;
    mutable std::vector<QRect> m_ink;
};

/// The pen of a curve and of its sample in the legend.
QPen curvePen(const QColor& colour, LinePattern pattern, double width);

} // namespace halbench::widgets
