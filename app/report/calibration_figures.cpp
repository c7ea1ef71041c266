#include "app/report/calibration_figures.h"

#include "control/base/units.h"

#include <QtCore/QCoreApplication>

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

} // namespace

widgets::Figure staticFrictionFigure(const std::vector<StaticFrictionPoint>& points,
                                     widgets::AngleUnit unit) {
    const bool isDegree = unit == widgets::AngleUnit::Degree;
    const double turn = isDegree ? 360.0 : 2.0 * Pi;
    widgets::Panel panel;
    panel.y = {utf8(Words::tr("current at the first motion")), "A", false, {}, {}, {}};
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
