#pragma once

#include "widgets/figure/figure_painter.h"

#include <functional>
#include <vector>

class QwtScaleMap;

namespace halbench::widgets {

/// What is drawn within a panel besides its curves, on the maps of its horizontal and left axis.
using PanelLayer = std::function<void(QPainter& painter, const QwtScaleMap& x, const QwtScaleMap& y,
                                      const QRectF& canvas, const Theme& theme)>;
struct PanelLayers {
    PanelLayer below; ///< under the curves; may be empty, as the other
    PanelLayer above;
};

class CurveLayers;

/// As without them; `layers` are by panel and may be fewer. `stays`, which began with this figure, has the
/// curves that need not be drawn again.
void paintFigure(QPainter& painter, const Figure& figure, const FigureLayout& layout, const Theme& theme,
                 QChar decimalPoint, const std::vector<PanelLayers>& layers, CurveLayers* stays = nullptr);

/// What the vertical axes need at both sides.
struct FigureMargins {
    double left_px = 0.0;
    double right_px = 0.0;
};
FigureMargins marginsOf(const Figure& figure);
/// With exactly these margins: who lays the same figure out at several widths asks for them once.
FigureLayout layOutWithin(const Figure& figure, int width_px, const FigureMargins& margins);
/// With these margins at least, for a figure in line with others.
FigureLayout layOut(const Figure& figure, int width_px, const FigureMargins& least);

} // namespace halbench::widgets
