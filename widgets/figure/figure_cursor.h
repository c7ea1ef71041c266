#pragma once

#include "widgets/figure/figure_probe.h"

#include <vector>

namespace halbench::widgets {

/// One abscissa, e.g. a frequency, read off every curve of a figure: in linked panels all that stand above
/// it, in a plane the samples that belong to it.

/// What the curves run along: the horizontal axis of linked panels, else the parameter; none of neither.
const Axis* alongAxis(const Figure& figure);
/// What a sample has on that axis.
std::optional<double> alongOf(const Figure& figure, const FigurePoint& point);
/// The sample nearest to it: of the wanted curve and panel when they have one, else of the first curve that
/// can be read.
std::optional<FigurePoint> pointAlong(const Figure& figure, double value, const FigurePoint& wanted = {});

/// What one curve has there.
struct CursorReading {
    std::size_t curve = 0;
    double x = 0.0;
    double y = 0.0;
    QString text; ///< with the curve's name, where it is not alone
};
/// Lines straight between their samples (over the logarithm of a logarithmic axis), markers that stand within
/// a few pixels. In a plane the nearest samples of all curves that have the parameter.
std::vector<CursorReading> readingsAt(const Figure& figure, const FigureLayout& layout, std::size_t panel,
                                      double along);

/// "frequency 2.4 Hz; magnitude: proposed 3 dB, before 1 dB; phase: ..."
QString cursorText(const Figure& figure, const FigureLayout& layout, double along);

/// A line through all linked panels with a box of readings in each; in a plane a ring on each curve.
void drawCursor(QPainter& painter, const Figure& figure, const FigureLayout& layout, double along,
                const Theme& theme);

} // namespace halbench::widgets
