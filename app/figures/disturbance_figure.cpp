#include "app/figures/disturbance_figure.h"

#include "app/figures/loop_curves.h"
#include "widgets/language/display_units.h"

#include <QtCore/QCoreApplication>

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

namespace halbench::app {
namespace {

using widgets::CurveStyle;
using Direction = widgets::ReferenceLine::Direction;

/// The words of this file for the translator.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::app::TuningFigures)
};

std::string utf8(const QString& text) {
    return text.toStdString();
}

std::vector<double> scaled(std::vector<double> values, double factor) {
    for (double& value : values) {
        value *= factor;
    }
    return values;
}

void add(widgets::Figure& figure, const control::LoadStep& step, double factor, const widgets::Curve& look) {
    widgets::Curve angle = look;
    angle.x = step.time_s;
    angle.y = scaled(step.angle_rad, factor);
    widgets::Curve current = look;
    current.x = step.time_s;
    current.y = step.current_A;
    figure.panels[0].curves.push_back(std::move(angle));
    figure.panels[1].curves.push_back(std::move(current));
}

} // namespace

std::optional<widgets::Figure> disturbanceFigure(const std::optional<control::LoadStep>& proposed,
                                                 const std::optional<control::LoadStep>& present,
                                                 widgets::AngleUnit unit, double load_A,
                                                 const std::optional<control::DisturbanceEnvelope>& band) {
    if (!proposed) {
        return std::nullopt;
    }
    const bool isDegree = unit == widgets::AngleUnit::Degree;
    const double factor = widgets::displayUnit("rad", unit).factor;
    widgets::Figure figure;
    figure.title =
        utf8(Words::tr("Load step equal to %1 A, linear model").arg(widgets::numberText(load_A, 2)));
    figure.x = {utf8(Words::tr("time")), "s", false, {}, {}, {}};
    figure.isLinked = true;
    figure.panels.resize(2);
    figure.panels[0].y = {
        utf8(Words::tr("angle from the reference")), isDegree ? "deg" : "rad", false, {}, {}, {}};
    figure.panels[1].y = {utf8(Words::tr("current")), "A", false, {}, {}, {}};
    figure.panels[1].height_px = 120;
    if (present) {
        add(figure, *present, factor, {utf8(Words::tr("before")), {}, {}, CurveStyle::DashedLine, 1});
    }
    add(figure, *proposed, factor,
        {present ? utf8(Words::tr("proposed")) : std::string(), {}, {}, CurveStyle::Line, 0});
    if (band) {
        figure.panels[0].curves.push_back(bandCurve(band->time_s, band->angle_rad, 1.0, factor));
    }
    figure.panels[0].lines = {{Direction::Horizontal, factor * proposed->peak_rad,
                               fmt::format("{} {:.3g}{}", utf8(Words::tr("peak")),
                                           factor * proposed->peak_rad, isDegree ? "\u00b0" : " rad")}};
    if (proposed->recoveryTime_s) {
        figure.panels[0].lines.push_back(
            {Direction::Vertical, *proposed->recoveryTime_s,
             fmt::format("{} {:.3g} s", utf8(Words::tr("settling time")), *proposed->recoveryTime_s)});
    }
    return figure;
}

} // namespace halbench::app
