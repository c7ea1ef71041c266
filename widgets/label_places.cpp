#include "widgets/label_places.h"

namespace halbench::widgets {

std::vector<QRectF> placesAtRow(const QRectF& canvas, double at_px, const QSizeF& size) {
    std::vector<QRectF> places;
    for (const double x_px : {canvas.right() - size.width() - 3.0, canvas.left() + 3.0}) {
        places.emplace_back(QPointF(x_px, at_px - size.height() - 1.0), size);
        places.emplace_back(QPointF(x_px, at_px + 1.0), size);
    }
    return places;
}

std::vector<QRectF> placesAtColumn(const QRectF& canvas, double at_px, const QSizeF& size) {
    std::vector<double> rows_px = {canvas.top() + 2.0, canvas.bottom() - size.height() - 2.0};
    for (double y_px = rows_px[0] + size.height() + 1.0; y_px < rows_px[1]; y_px += size.height() + 1.0) {
        rows_px.push_back(y_px);
    }
    std::vector<QRectF> places;
    for (const double y_px : rows_px) {
        places.emplace_back(QPointF(at_px + 2.0, y_px), size);
        places.emplace_back(QPointF(at_px - size.width() - 2.0, y_px), size);
    }
    return places;
}

} // namespace halbench::widgets
