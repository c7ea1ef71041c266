#include "widgets/figure/figure_handle.h"

#include "widgets/figure/figure_scales.h"

#include <QLineF>
#include <QPainter>

#include <cmath>

namespace halbench::widgets {
namespace {

struct Maps {
    FigureScale x;
    FigureScale y;
    QwtScaleMap xMap;
    QwtScaleMap yMap;

    Maps(const Figure& figure, const FigureLayout& layout, std::size_t panel)
        : x(horizontalScale(figure, layout.panels[panel].canvas.width())),
          y(verticalScale(figure.panels[panel], layout.panels[panel].canvas.height())),
          xMap(x.map(layout.panels[panel].canvas.left(), layout.panels[panel].canvas.right())),
          yMap(y.map(layout.panels[panel].canvas.bottom(), layout.panels[panel].canvas.top())) {}
};

void fix(Axis& axis, const FigureScale& scale) {
    axis.min = scale.division.lowerBound();
    axis.max = scale.division.upperBound();
}

} // namespace

std::optional<QPointF> placeOfHandle(const Figure& figure, const FigureLayout& layout,
                                     const FigureHandle& handle) {
    if (handle.panel >= figure.panels.size()) {
        return std::nullopt;
    }
    const Maps maps(figure, layout, handle.panel);
    const QPointF place(maps.xMap.transform(handle.x), maps.yMap.transform(handle.y));
    const bool isSeen = std::isfinite(place.x()) && std::isfinite(place.y()) &&
                        layout.panels[handle.panel].canvas.contains(place);
    return isSeen ? std::optional(place) : std::nullopt;
}

std::optional<std::size_t> handleAt(const Figure& figure, const FigureLayout& layout,
                                    const std::vector<FigureHandle>& handles, const QPointF& at) {
    constexpr double Reach_px = 12.0;
    std::optional<std::size_t> nearest;
    double least_px = Reach_px;
    for (std::size_t i = 0; i < handles.size(); ++i) {
        const auto place = placeOfHandle(figure, layout, handles[i]);
        const double away_px = place ? QLineF(*place, at).length() : Reach_px;
        if (away_px < least_px) {
            nearest = i;
            least_px = away_px;
        }
    }
    return nearest;
}

QPointF valuesAt(const Figure& figure, const FigureLayout& layout, std::size_t panel, const QPointF& at) {
    const Maps maps(figure, layout, panel);
    return {maps.xMap.invTransform(at.x()), maps.yMap.invTransform(at.y())};
}

Figure withAxesOf(Figure figure, const Figure& drawn, const FigureLayout& layout) {
    if (figure.panels.size() != drawn.panels.size() || layout.panels.size() != drawn.panels.size()) {
        return figure;
    }
    for (std::size_t i = 0; i < drawn.panels.size(); ++i) {
        const Maps maps(drawn, layout, i);
        fix(figure.x, maps.x);
        fix(figure.panels[i].y, maps.y);
    }
    return figure;
}

void drawHandle(QPainter& painter, const QPointF& place, bool isHeld, const Theme& theme) {
    const double radius_px = isHeld ? 7.0 : 5.5;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(theme.plotBackground, 2.0));
    painter.setBrush(theme.accent);
    painter.drawEllipse(place, radius_px, radius_px);
}

} // namespace halbench::widgets
