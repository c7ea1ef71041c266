#include "app/workspaces/parts/figure_units.h"

#include "control/base/units.h"
#include "widgets/figure/figure_view.h"

#include <optional>
#include <vector>

namespace halbench::app {

namespace {

void scale(std::optional<double>& number, double factor) {
    if (number) {
        *number *= factor;
    }
}

void scaleAxis(widgets::Axis& axis, double factor) {
    scale(axis.min, factor);
    scale(axis.max, factor);
    scale(axis.tickStep, factor);
}

void scaleAll(std::vector<double>& values, double factor) {
    for (double& value : values) {
        value *= factor;
    }
}

void scalePanel(widgets::Panel& panel, double factor) {
    scaleAxis(panel.y, factor);
    for (widgets::Curve& curve : panel.curves) {
        scaleAll(curve.y, factor);
    }
    for (widgets::ReferenceLine& line : panel.lines) {
        if (line.direction == widgets::ReferenceLine::Direction::Horizontal) {
            line.at *= factor;
        }
    }
}

} // namespace

double frequencyFactor(FrequencyUnit unit) {
    return unit == FrequencyUnit::RadiansPerSecond ? 2.0 * Pi : 1.0;
}

widgets::Figure inFrequencyUnit(widgets::Figure figure, FrequencyUnit unit) {
    if (unit == FrequencyUnit::Hertz) {
        return figure; // as they are computed
    }
    const bool isAcross = figure.x.unit == "Hz";
    const bool isAlong = figure.parameter && figure.parameter->unit == "Hz";
    const double factor = frequencyFactor(unit);
    if (isAcross) {
        scaleAxis(figure.x, factor);
        figure.x.unit = "rad/s";
    }
    if (isAlong) {
        scaleAxis(*figure.parameter, factor);
        figure.parameter->unit = "rad/s";
    }
    for (widgets::Panel& panel : figure.panels) {
        for (widgets::Curve& curve : panel.curves) {
            scaleAll(curve.x, isAcross ? factor : 1.0);
            scaleAll(curve.parameter, isAlong ? factor : 1.0);
        }
        for (widgets::ReferenceLine& line : panel.lines) {
            const bool isVertical = line.direction == widgets::ReferenceLine::Direction::Vertical;
            line.at *= isVertical && isAcross ? factor : 1.0;
        }
    }
    return figure;
}

void showInFrequencyUnit(widgets::FigureView& view, const widgets::Figure& figure, FrequencyUnit unit) {
    view.setFigure(inFrequencyUnit(figure, unit));
    if (unit != FrequencyUnit::Hertz) {
        view.setNumbers(figure);
    }
}

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
