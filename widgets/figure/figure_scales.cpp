#include "widgets/figure/figure_scales.h"

#include "widgets/figure/figure_painter.h"

#include <qwt_scale_engine.h>
#include <qwt_transform.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace halbench::widgets {
namespace {

constexpr double HorizontalTickDistance_px = 80.0;
constexpr double VerticalTickDistance_px = 26.0;
constexpr double Margin_ratio = 0.05;
constexpr int MinorTicks = 5;

struct Extent {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void include(double value, bool isLogarithmic) {
        if (std::isfinite(value) && (!isLogarithmic || value > 0.0)) {
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
};

/// A range that is never empty, even for no data at all.
Extent nonEmpty(Extent extent, bool isLogarithmic) {
    if (extent.low > extent.high) {
        return isLogarithmic ? Extent{1.0, 10.0} : Extent{0.0, 1.0};
    }
    if (isLogarithmic) {
        return extent.high > extent.low ? extent : Extent{0.5 * extent.low, 2.0 * extent.high};
    }
    const double size = std::max(std::abs(extent.low), std::abs(extent.high));
    if (extent.high - extent.low <= 1e-12 * size || size == 0.0) {
        const double half = size == 0.0 ? 1.0 : 0.1 * size;
        return {extent.low - half, extent.high + half};
    }
    return extent;
}

/// Moves an end outwards to the next tick when it is that close: 0 ... 2.99 s becomes 0 ... 3 s.
Extent snapped(const Extent& extent, int majorTicks) {
    constexpr double Reach_ratio = 0.02;
    const QList<double> ticks = QwtLinearScaleEngine()
                                    .divideScale(extent.low, extent.high, majorTicks, 0)
                                    .ticks(QwtScaleDiv::MajorTick);
    if (ticks.size() < 2) {
        return extent;
    }
    const double step = ticks[1] - ticks[0];
    const double reach = Reach_ratio * (extent.high - extent.low);
    const double below = std::floor(extent.low / step) * step;
    const double above = std::ceil(extent.high / step) * step;
    return {extent.low - below <= reach ? below : extent.low,
            above - extent.high <= reach ? above : extent.high};
}

/// The wished distance of ticks; a third of it where it would leave fewer than three (45 -> 15 degrees),
/// twice or four times as much where the ticks would be too dense (90, 180 degrees).
std::optional<double> usableStep(const Axis& axis, double range, int majorTicks) {
    if (!axis.tickStep || *axis.tickStep <= 0.0) {
        return std::nullopt;
    }
    for (const double factor : {1.0 / 3.0, 1.0, 2.0, 4.0}) {
        const double step = factor * *axis.tickStep;
        const bool isFine = range / *axis.tickStep >= 4.0 && factor < 1.0;
        if (!isFine && range / step >= 2.0 && range / step <= 1.5 * majorTicks) {
            return step;
        }
    }
    return std::nullopt;
}

FigureScale scaleOf(const Axis& axis, Extent extent, bool isWidened, int majorTicks) {
    extent = nonEmpty(extent, axis.isLogarithmic);
    if (isWidened && !axis.isLogarithmic) {
        const double margin = Margin_ratio * (extent.high - extent.low);
        extent = {extent.low - margin, extent.high + margin};
    } else if (!axis.isLogarithmic) {
        extent = snapped(extent, majorTicks);
    }
    const double low = axis.min.value_or(extent.low);
    const double high = axis.max.value_or(extent.high);
    FigureScale scale;
    scale.isLogarithmic = axis.isLogarithmic;
    if (axis.isLogarithmic) {
        scale.division = QwtLogScaleEngine().divideScale(low, high, majorTicks, 10);
        return scale;
    }
    if (const std::optional<double> step = usableStep(axis, high - low, majorTicks)) {
        scale.division = QwtLinearScaleEngine().divideScale(low, high, majorTicks, MinorTicks, *step);
        return scale;
    }
    // Few ticks may leave a single label inside the extent, and with it no scale at all.
    for (int ticks = majorTicks; ticks <= 4 * majorTicks; ++ticks) {
        scale.division = QwtLinearScaleEngine().divideScale(low, high, ticks, MinorTicks);
        if (scale.division.ticks(QwtScaleDiv::MajorTick).size() >= 3) {
            break;
        }
    }
    return scale;
}

Extent extentOf(const std::vector<Curve>& curves, bool isRight, const Axis& axis) {
    Extent extent;
    for (const Curve& curve : curves) {
        if (curve.style == CurveStyle::Band) {
            continue; // one motor that runs away would hide all others
        }
        for (std::size_t i = 0; curve.isRight == isRight && i < curve.y.size(); ++i) {
            extent.include(curve.y[i], axis.isLogarithmic);
        }
    }
    return extent;
}

int verticalTicks(double length_px) {
    return std::max(2, static_cast<int>(length_px / VerticalTickDistance_px));
}

} // namespace

QwtScaleMap FigureScale::map(double first_px, double last_px) const {
    QwtScaleMap result;
    if (isLogarithmic) {
        result.setTransformation(new QwtLogTransform); // owned by the map
    }
    result.setScaleInterval(division.lowerBound(), division.upperBound());
    result.setPaintInterval(first_px, last_px);
    return result;
}

FigureScale horizontalScale(const Figure& figure, double length_px) {
    Extent extent;
    bool isWidened = false;
    for (const Panel& panel : figure.panels) {
        for (const Curve& curve : panel.curves) {
            if (curve.style == CurveStyle::Band) {
                continue;
            }
            isWidened = isWidened || isMarkers(curve.style);
            for (const double value : curve.x) {
                extent.include(value, figure.x.isLogarithmic);
            }
        }
    }
    return scaleOf(figure.x, extent, isWidened, static_cast<int>(length_px / HorizontalTickDistance_px));
}

FigureScale verticalScale(const Panel& panel, double length_px) {
    Extent extent = extentOf(panel.curves, false, panel.y);
    for (const ReferenceLine& line : panel.lines) {
        if (line.direction == ReferenceLine::Direction::Horizontal) {
            extent.include(line.at, panel.y.isLogarithmic);
        }
    }
    return scaleOf(panel.y, extent, true, verticalTicks(length_px));
}

FigureScale rightScale(const Panel& panel, double length_px) {
    return scaleOf(*panel.right, extentOf(panel.curves, true, *panel.right), true, verticalTicks(length_px));
}

void makeEqualScale(Figure& figure, int width_px) {
    Panel& panel = figure.panels.front();
    // Again: other labels may need another margin.
    for (int pass = 0; pass < 2; ++pass) {
        const QRectF canvas = layOut(figure, width_px).panels.front().canvas;
        const QwtScaleDiv x = horizontalScale(figure, canvas.width()).division;
        const QwtScaleDiv y = verticalScale(panel, canvas.height()).division;
        const double perPixel = std::max(x.range() / canvas.width(), y.range() / canvas.height());
        const auto widen = [perPixel](Axis& axis, const QwtScaleDiv& division, double length_px) {
            const double middle = 0.5 * (division.lowerBound() + division.upperBound());
            axis.min = middle - 0.5 * perPixel * length_px;
            axis.max = middle + 0.5 * perPixel * length_px;
        };
        widen(figure.x, x, canvas.width());
        widen(panel.y, y, canvas.height());
    }
}

} // namespace halbench::widgets
