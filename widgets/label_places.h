#pragma once

#include <QRectF>
#include <QSizeF>

#include <vector>

namespace halbench::widgets {

/// Where the label of a reference line may stand, the best place first; all in pixels. Beside a horizontal
/// line at `at_px`: above and below it, at its right end first.
std::vector<QRectF> placesAtRow(const QRectF& canvas, double at_px, const QSizeF& size);
/// Beside a vertical one, on both sides: at the top, at the bottom, then row by row, because others may stand
/// close to it.
std::vector<QRectF> placesAtColumn(const QRectF& canvas, double at_px, const QSizeF& size);

} // namespace halbench::widgets
