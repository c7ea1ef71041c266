#include "widgets/figure/figure_axis.h"
#include "widgets/figure/figure_scales.h"
#include "widgets/figure/panel_layers.h"

#include <QFontMetricsF>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace halbench::widgets {
namespace {

constexpr double Edge_px = 8.0;
constexpr double RightEdge_px = 20.0; ///< half of the last tick label fits
constexpr double TitleRow_px = 24.0;
constexpr double LegendRow_px = 18.0;
constexpr double PanelGap_px = 14.0;
constexpr double BottomRows_px = 44.0; ///< ticks, tick labels, axis title
constexpr double LegendSample_px = 24.0;
constexpr double LegendGap_px = 20.0;
constexpr double AxisTitle_px = 20.0;

int colourOf(const Curve& curve, std::size_t position) {
    return curve.colour.value_or(static_cast<int>(position)) % 8;
}

/// Width of the vertical axes: the widest tick label of all panels, so that the panels align.
double leftMargin_px(const Figure& figure) {
    double labels_px = 0.0;
    for (const Panel& panel : figure.panels) {
        const QRectF canvas(0.0, 0.0, 1.0, panel.height_px);
        const FigureAxis axis(verticalScale(panel, panel.height_px), QwtScaleDraw::LeftScale, canvas);
        labels_px = std::max(labels_px, axis.extent(figureFont()));
    }
    return std::ceil(Edge_px + AxisTitle_px + labels_px);
}

/// The same at the right; nothing where no panel has an axis there.
double rightAxes_px(const Figure& figure) {
    double labels_px = 0.0;
    for (const Panel& panel : figure.panels) {
        if (panel.right) {
            const QRectF canvas(0.0, 0.0, 1.0, panel.height_px);
            const FigureAxis axis(rightScale(panel, panel.height_px), QwtScaleDraw::RightScale, canvas);
            labels_px = std::max(labels_px, axis.extent(figureFont()));
        }
    }
    return labels_px > 0.0 ? std::ceil(AxisTitle_px + labels_px + Edge_px - RightEdge_px) : 0.0;
}

} // namespace

QFont figureFont(bool isTitle) {
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(isTitle ? 13 : 11);
    font.setBold(isTitle);
    font.setHintingPreference(QFont::PreferNoHinting);
    return font;
}

FigureMargins marginsOf(const Figure& figure) {
    return {leftMargin_px(figure), rightAxes_px(figure)};
}

FigureLayout layOut(const Figure& figure, int width_px) {
    return layOut(figure, width_px, {});
}

FigureLayout layOut(const Figure& figure, int width_px, const FigureMargins& least) {
    const FigureMargins own = marginsOf(figure);
    return layOutWithin(figure, width_px,
                        {std::max(own.left_px, least.left_px), std::max(own.right_px, least.right_px)});
}

FigureLayout layOutWithin(const Figure& figure, int width_px, const FigureMargins& margins) {
    FigureLayout layout;
    const QFontMetricsF metrics(figureFont());
    const double left_px = margins.left_px;
    const double right_px = width_px - RightEdge_px - margins.right_px;
    double y_px = figure.title.empty() ? Edge_px : TitleRow_px;
    layout.titleBaseline = 16.0;
    std::set<std::tuple<std::string, int, CurveStyle>> alreadyNamed;
    for (const Panel& panel : figure.panels) {
        FigureLayout::PanelPlace place;
        double x_px = left_px;
        for (std::size_t i = 0; i < panel.curves.size(); ++i) {
            const Curve& curve = panel.curves[i];
            const int colour = colourOf(curve, i);
            if (curve.label.empty() || !alreadyNamed.insert({curve.label, colour, curve.style}).second) {
                continue;
            }
            const double length_px =
                LegendSample_px + metrics.horizontalAdvance(QString::fromStdString(curve.label));
            if (!place.legend.empty() && x_px + length_px > right_px) {
                x_px = left_px;
                y_px += LegendRow_px;
            }
            place.legend.push_back({&curve, colour, x_px, y_px + 12.0});
            x_px += length_px + LegendGap_px;
        }
        y_px += place.legend.empty() ? 0.0 : LegendRow_px;
        place.canvas = QRectF(left_px, y_px, right_px - left_px, panel.height_px);
        y_px += panel.height_px + PanelGap_px;
        layout.panels.push_back(std::move(place));
    }
    layout.size = QSize(width_px, static_cast<int>(y_px - PanelGap_px + BottomRows_px));
    return layout;
}

} // namespace halbench::widgets
