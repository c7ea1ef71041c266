#include "app/workspaces/figure_units.h"

#include <optional>

namespace halbench::app {

namespace {

void scale(std::optional<double>& number, double factor) {
    if (number) {
        *number *= factor;
    }
}

void scalePanel(widgets::Panel& panel, double factor) {
    scale(panel.y.min, factor);
    scale(panel.y.max, factor);
    scale(panel.y.tickStep, factor);
    for (widgets::Curve& curve : panel.curves) {
        for (double& value : curve.y) {
            value *= factor;
        }
    }
    for (widgets::ReferenceLine& line : panel.lines) {
        if (line.direction == widgets::ReferenceLine::Direction::Horizontal) {
            line.at *= factor;
        }
    }
}

} // namespace

widgets::Figure inUnits(widgets::Figure figure, const DisplayUnits& units) {
    for (widgets::Panel& panel : figure.panels) {
        if (panel.y.unit == "rad" || panel.y.unit == "rad/s") {
            const DisplayQuantity shown = displayQuantity(panel.y.unit, units);
            scalePanel(panel, shown.factor);
            panel.y.unit = shown.unit.toStdString();
        }
    }
    return figure;
}

} // namespace halbench::app
