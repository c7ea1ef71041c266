#pragma once

#include "widgets/figure/figure.h"
#include "widgets/theme/theme.h"

#include <QFont>
#include <QRectF>
#include <QSize>

#include <vector>

class QPainter;

namespace halbench::widgets {

/// Where everything of a figure goes, in pixels.
struct FigureLayout {
    struct LegendEntry {
        const Curve* curve = nullptr;
        int colour = 0;
        double left = 0.0;
        double baseline = 0.0;
    };
    struct PanelPlace {
        QRectF canvas;
        std::vector<LegendEntry> legend;
    };
    QSize size;
    double titleBaseline = 0.0;
    std::vector<PanelPlace> panels;
};

FigureLayout layOut(const Figure& figure, int width_px);

/// Draws on whatever the painter paints: SVG, PDF, pixels. Reports keep the point in their numbers, the
/// window has the user's decimal point.
void paintFigure(QPainter& painter, const Figure& figure, const FigureLayout& layout, const Theme& theme,
                 QChar decimalPoint = QLatin1Char('.'));

/// Fonts have pixel sizes, so that no screen's resolution enters.
QFont figureFont(bool isTitle = false);

} // namespace halbench::widgets
