#include "app/figures/calibration_figures.h"

#include "control/base/units.h"
#include "control/identify/ellipse_fit.h"

#include <QtCore/QCoreApplication>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::app {
namespace {

/// The words of this file for the translator.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::app::CalibrationFigures)
};

std::string utf8(const QString& text) {
    return text.toStdString();
}

constexpr double MilliteslaPerTesla = 1e3;

std::optional<control::HallEllipse> ellipseOf(const CalibrateResult& result) {
    control::HallEllipse ellipse;
    const std::pair<const char*, double*> parts[] = {{"hall.offset_a", &ellipse.offsetA_T},
                                                     {"hall.offset_b", &ellipse.offsetB_T},
                                                     {"hall.gain_ratio", &ellipse.gain_ratio},
                                                     {"hall.quadrature", &ellipse.quadrature_rad},
                                                     {"hall.amplitude", &ellipse.amplitude_T}};
    for (const auto& [name, part] : parts) {
        const auto found =
            std::find_if(result.figures.begin(), result.figures.end(),
                         [name = name](const CalibrationFigure& figure) { return figure.name == name; });
        if (found == result.figures.end() || !found->estimate.value) {
            return std::nullopt;
        }
        *part = *found->estimate.value;
    }
    return ellipse.gain_ratio > 0.0 ? std::optional(ellipse) : std::nullopt;
}

/// What the sensors read at this angle, if the ellipse were all.
HallPoint pointOf(const control::HallEllipse& ellipse, double angle_rad) {
    return {ellipse.offsetA_T + ellipse.amplitude_T * std::cos(angle_rad),
            ellipse.offsetB_T +
                ellipse.amplitude_T * ellipse.gain_ratio * std::sin(angle_rad + ellipse.quadrature_rad)};
}

} // namespace

std::optional<widgets::Figure> hallEllipseFigure(const CalibrateResult& result) {
    const auto ellipse = ellipseOf(result);
    if (!ellipse || result.hallPoints.empty()) {
        return std::nullopt;
    }
    widgets::Curve fit{utf8(Words::tr("fitted ellipse")), {}, {}, widgets::CurveStyle::Line, 1};
    constexpr int Steps = 180;
    for (int i = 0; i <= Steps; ++i) {
        const HallPoint point = pointOf(*ellipse, 2.0 * Pi * i / Steps);
        fit.x.push_back(MilliteslaPerTesla * point.a_T);
        fit.y.push_back(MilliteslaPerTesla * point.b_T);
    }
    widgets::Curve measured{utf8(Words::tr("measured")), {}, {}, widgets::CurveStyle::Points, 0};
    for (const HallPoint& point : result.hallPoints) {
        measured.x.push_back(MilliteslaPerTesla * point.a_T);
        measured.y.push_back(MilliteslaPerTesla * point.b_T);
    }
    widgets::Panel panel;
    panel.y = {utf8(Words::tr("Hall B")), "mT", false, {}, {}, {}};
    panel.height_px = 300;
    panel.curves = {std::move(measured), std::move(fit)};
    return widgets::Figure{utf8(Words::tr("Hall readings and their ellipse")),
                           {utf8(Words::tr("Hall A")), "mT", false, {}, {}, {}},
                           {std::move(panel)},
                           true}; // whether it is a circle is what one looks for
}

std::optional<widgets::Figure> hallResidualFigure(const CalibrateResult& result, widgets::AngleUnit unit) {
    const auto ellipse = ellipseOf(result);
    if (!ellipse || result.hallPoints.empty()) {
        return std::nullopt;
    }
    const bool isDegree = unit == widgets::AngleUnit::Degree;
    widgets::Curve residual{utf8(Words::tr("measured")), {}, {}, widgets::CurveStyle::Points, 0};
    for (const HallPoint& point : result.hallPoints) {
        const double angle_rad = control::hallAngle_rad(*ellipse, point.a_T, point.b_T);
        const HallPoint fit = pointOf(*ellipse, angle_rad);
        // The reading and its point of the fit lie on one ray from the centre.
        const double outside_T = std::hypot(point.a_T - ellipse->offsetA_T, point.b_T - ellipse->offsetB_T) -
                                 std::hypot(fit.a_T - ellipse->offsetA_T, fit.b_T - ellipse->offsetB_T);
        residual.x.push_back(isDegree ? radiansToDegrees(angle_rad) : angle_rad);
        residual.y.push_back(MilliteslaPerTesla * outside_T);
    }
    const double half = isDegree ? 180.0 : Pi;
    widgets::Panel panel;
    panel.y = {utf8(Words::tr("reading minus ellipse")), "mT", false, {}, {}, {}};
    panel.height_px = 300;
    panel.lines = {{widgets::ReferenceLine::Direction::Horizontal, 0.0, {}}};
    panel.curves = {std::move(residual)};
    return widgets::Figure{utf8(Words::tr("Residual of the ellipse")),
                           {utf8(Words::tr("angle")), isDegree ? "deg" : "rad", false, -half, half,
                            isDegree ? std::optional(90.0) : std::nullopt},
                           {std::move(panel)}};
}

widgets::Figure staticFrictionFigure(const std::vector<StaticFrictionPoint>& points,
                                     widgets::AngleUnit unit) {
    const bool isDegree = unit == widgets::AngleUnit::Degree;
    const double turn = isDegree ? 360.0 : 2.0 * Pi;
    widgets::Panel panel;
    panel.y = {utf8(Words::tr("breakaway current")), "A", false, {}, {}, {}};
    widgets::Curve forward{utf8(Words::tr("forward")), {}, {}, widgets::CurveStyle::Points, 0};
    widgets::Curve reverse{
        utf8(Words::tr("reverse, sign removed")), {}, {}, widgets::CurveStyle::HollowPoints, 1};
    for (const StaticFrictionPoint& point : points) {
        widgets::Curve& curve = point.current_A < 0.0 ? reverse : forward;
        const double turns = point.angle_rad / (2.0 * Pi);
        curve.x.push_back(turn * (turns - std::floor(turns))); // the place on the rotor, whatever the turn
        curve.y.push_back(std::abs(point.current_A));
    }
    for (widgets::Curve* curve : {&forward, &reverse}) {
        if (!curve->x.empty()) {
            panel.curves.push_back(std::move(*curve));
        }
    }
    return {utf8(Words::tr("Static friction over the angle")),
            {utf8(Words::tr("angle")), isDegree ? "deg" : "rad", false, {}, {}, {}},
            {std::move(panel)}};
}

} // namespace halbench::app
