#include "widgets/figure/label_places.h"

#include <qwt_scale_map.h>

#include <algorithm>

namespace halbench::widgets {
namespace {

/// As QRectF::intersects, of rectangles that are not empty.
bool meets(const QRectF& box, const QRectF& place) {
    return !(box.left() >= place.right() || place.left() >= box.right() || box.top() >= place.bottom() ||
             place.top() >= box.bottom());
}

} // namespace

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

std::vector<QRectF> boxesWithin(const QRectF& region, const std::vector<Curve>& curves, const QwtScaleMap& x,
                                const QwtScaleMap& y) {
    std::vector<QRectF> boxes;
    for (const Curve& curve : curves) {
        QPointF from;
        for (std::size_t i = 0; curve.style != CurveStyle::Band && i < curve.x.size(); ++i) {
            const QPointF to(x.transform(curve.x[i]), y.transform(curve.y[i]));
            const QRectF box = QRectF(from, to).normalized().adjusted(-1.0, -1.0, 1.0, 1.0);
            if (i > 0 && meets(box, region)) {
                boxes.push_back(box);
            }
            from = to;
        }
    }
    return boxes;
}

bool isOnCurve(const QRectF& place, const std::vector<QRectF>& boxes) {
    return std::any_of(boxes.begin(), boxes.end(), [&](const QRectF& box) { return meets(box, place); });
}

} // namespace halbench::widgets
