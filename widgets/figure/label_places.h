#pragma once

#include "widgets/figure/figure.h"

#include <QRectF>
#include <QSizeF>

#include <vector>

class QwtScaleMap;

namespace halbench::widgets {

/// Where the label of a reference line may stand, the best place first; all in pixels. Beside a horizontal
/// line at `at_px`: above and below it, at its right end first.
std::vector<QRectF> placesAtRow(const QRectF& canvas, double at_px, const QSizeF& size);
/// Beside a vertical one, on both sides: at the top, at the bottom, then row by row, because others may stand
/// close to it.
std::vector<QRectF> placesAtColumn(const QRectF& canvas, double at_px, const QSizeF& size);

/// The box of each segment of each curve that comes into the rectangle, in pixels and one of them wider on
/// all sides; bands have none. One that is no number is everywhere.
std::vector<QRectF> boxesWithin(const QRectF& region, const std::vector<Curve>& curves, const QwtScaleMap& x,
                                const QwtScaleMap& y);
/// Whether a label there, within that rectangle, would stand on a curve.
bool isOnCurve(const QRectF& place, const std::vector<QRectF>& boxes);

} // namespace halbench::widgets
