#include "widgets/figure/figures.h"

#include "control/base/units.h"

#include <QCoreApplication>

#include <cmath>
#include <utility>

namespace halbench::widgets {
namespace {

constexpr double PhaseTick_deg = 45.0;

/// The words of this file for the translator.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::widgets::Figures)
};

std::string utf8(const QString& text) {
    return text.toStdString();
}

ReferenceLine zeroLine() {
    return {ReferenceLine::Direction::Horizontal, 0.0, {}};
}

Curve pointsOf(const std::vector<RegressionContent::Point>& points, bool isUsed,
               double RegressionContent::Point::*value) {
    Curve curve;
    curve.label = isUsed ? utf8(Words::tr("measured")) : utf8(Words::tr("excluded"));
    curve.style = isUsed ? CurveStyle::Points : CurveStyle::HollowPoints;
    curve.colour = 0;
    for (const RegressionContent::Point& point : points) {
        if (point.isUsed == isUsed) {
            curve.x.push_back(point.x);
            curve.y.push_back(point.*value);
        }
    }
    return curve;
}

void appendPoints(Panel& panel, const RegressionContent& content, double RegressionContent::Point::*value) {
    for (const bool isUsed : {true, false}) {
        Curve curve = pointsOf(content.points, isUsed, value);
        if (!curve.x.empty()) {
            panel.curves.push_back(std::move(curve));
        }
    }
}

} // namespace

Figure regressionFigure(const RegressionContent& content) {
    Panel fit;
    fit.y = content.y;
    fit.height_px = 300;
    int colour = 1;
    for (Curve curve : content.fits) {
        curve.colour = curve.colour.value_or(colour++);
        fit.curves.push_back(std::move(curve));
    }
    appendPoints(fit, content, &RegressionContent::Point::y);

    Panel residuals;
    residuals.y = {utf8(Words::tr("residual")), content.y.unit, false, {}, {}, {}};
    residuals.height_px = 120;
    residuals.lines = {zeroLine()};
    appendPoints(residuals, content, &RegressionContent::Point::residual);
    return {content.title, content.x, {std::move(fit), std::move(residuals)}};
}

Figure bodeFigure(const BodeContent& content) {
    Panel magnitude;
    magnitude.y = {utf8(Words::tr("magnitude")), "dB", false, {}, {}, {}};
    magnitude.lines = content.magnitudeLines;
    Panel phase;
    phase.y = {utf8(Words::tr("phase")), "deg", false, {}, {}, PhaseTick_deg};
    phase.lines = content.phaseLines;
    for (const BodeContent::Response& response : content.responses) {
        magnitude.curves.push_back(
            {response.label, response.frequency_Hz, response.magnitude_dB, response.style, response.colour});
        phase.curves.push_back(
            {response.label, response.frequency_Hz, response.phase_deg, response.style, response.colour});
    }
    return {content.title,
            {utf8(Words::tr("frequency")), "Hz", true, {}, {}, {}},
            {std::move(magnitude), std::move(phase)},
            false,
            true};
}

Figure ellipseFigure(const EllipseContent& content) {
    Panel panel;
    panel.y = content.y;
    panel.height_px = 320;
    // Cholesky factor L of the covariance: the unit circle becomes the ellipse centre + sqrt(quantile) L
    // (cos, sin).
    const double l11 = std::sqrt(content.covariance[0][0]);
    const double l21 = content.covariance[1][0] / l11;
    const double l22 = std::sqrt(std::fmax(content.covariance[1][1] - l21 * l21, 0.0));
    int colour = 1;
    for (const EllipseContent::Level& level : content.levels) {
        Curve curve{level.label, {}, {}, CurveStyle::Line, colour++};
        const int parts = 180;
        for (int i = 0; i <= parts; ++i) {
            const double angle_rad = 2.0 * Pi * i / parts;
            const double radius = std::sqrt(level.quantile);
            curve.x.push_back(content.centre[0] + radius * l11 * std::cos(angle_rad));
            curve.y.push_back(content.centre[1] +
                              radius * (l21 * std::cos(angle_rad) + l22 * std::sin(angle_rad)));
        }
        panel.curves.push_back(std::move(curve));
    }
    panel.curves.push_back(
        {utf8(Words::tr("estimate")), {content.centre[0]}, {content.centre[1]}, CurveStyle::Points, 0});
    for (const Curve& mark : content.marks) {
        panel.curves.push_back(mark);
    }
    return {content.title, content.x, {std::move(panel)}};
}

} // namespace halbench::widgets
