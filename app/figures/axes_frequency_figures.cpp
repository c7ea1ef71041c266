#include "app/figures/axes_frequency_figures.h"

#include "control/base/units.h"
#include "widgets/figure/figures.h"

#include <QtCore/QCoreApplication>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <complex>
#include <utility>

namespace halbench::app {
namespace {

using widgets::CurveStyle;
using Direction = widgets::ReferenceLine::Direction;

struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::app::AxesFrequencyFigures)
};

std::string utf8(const QString& text) {
    return text.toStdString();
}

double decibel(double ratio) {
    return 20.0 * std::log10(ratio);
}

double hertzOf(const AxesFrequencyPoint& point) {
    return point.plant.frequency_rad_s / (2.0 * Pi);
}

/// The angle that continues the one before.
double unwrapped(double phase_rad, double near_deg) {
    const double phase_deg = radiansToDegrees(phase_rad);
    return phase_deg + 360.0 * std::round((near_deg - phase_deg) / 360.0);
}

int colourOf(std::size_t axis) {
    return static_cast<int>(axis);
}

/// Loop of one axis; `used` and the rest apart.
std::array<widgets::BodeContent::Response, 2> loopOf(const AxesFrequencyResult& result, std::size_t axis) {
    std::array<widgets::BodeContent::Response, 2> both;
    both[0].label = result.axes[axis].axis.id;
    both[0].style = CurveStyle::Points;
    both[1].style = CurveStyle::HollowPoints;
    double near_deg = -180.0;
    for (const AxesFrequencyPoint& point : result.points) {
        widgets::BodeContent::Response& response = point.isUsed[axis] ? both[0] : both[1];
        const std::complex<double> value = point.loop.loops[axis].value;
        const double phase_deg = unwrapped(std::arg(value), near_deg);
        near_deg = point.isUsed[axis] ? phase_deg : near_deg;
        response.colour = colourOf(axis);
        response.frequency_Hz.push_back(hertzOf(point));
        response.magnitude_dB.push_back(decibel(std::abs(value)));
        response.phase_deg.push_back(phase_deg);
    }
    return both;
}

widgets::Panel coherenceOf(const AxesFrequencyResult& result) {
    widgets::Panel panel;
    panel.y = {utf8(Words::tr("coherence")), {}, false, 0.0, 1.0, {}};
    panel.height_px = 110;
    for (std::size_t axis = 0; axis < result.axes.size(); ++axis) {
        widgets::Curve curve{{}, {}, {}, CurveStyle::Points, colourOf(axis)};
        for (const AxesFrequencyPoint& point : result.points) {
            curve.x.push_back(hertzOf(point));
            curve.y.push_back(point.plant.coherence(static_cast<Eigen::Index>(axis)));
        }
        panel.curves.push_back(std::move(curve));
    }
    panel.lines = {{Direction::Horizontal, result.config.leastCoherence,
                    fmt::format("{:.3g}", result.config.leastCoherence)}};
    return panel;
}

widgets::Figure figureOverFrequency(const QString& title, const QString& quantity, const char* unit) {
    widgets::Figure figure;
    figure.title = utf8(title);
    figure.x = {utf8(Words::tr("frequency")), "Hz", true, {}, {}, {}};
    figure.panels.emplace_back();
    figure.panels.back().y = {utf8(quantity), unit, false, {}, {}, {}};
    figure.panels.back().height_px = 260;
    return figure;
}

} // namespace

widgets::Figure axesLoopsFigure(const AxesFrequencyResult& result) {
    widgets::BodeContent content;
    content.title = utf8(Words::tr("Open loop of each axis, the others closed"));
    content.magnitudeLines = {{Direction::Horizontal, 0.0, "0 dB"}};
    content.phaseLines = {{Direction::Horizontal, -180.0, "\u2212180\u00b0"}};
    for (std::size_t axis = 0; axis < result.axes.size(); ++axis) {
        for (widgets::BodeContent::Response& response : loopOf(result, axis)) {
            if (!response.frequency_Hz.empty()) {
                content.responses.push_back(std::move(response));
            }
        }
    }
    widgets::Figure figure = widgets::bodeFigure(content);
    figure.panels.push_back(coherenceOf(result));
    return figure;
}

widgets::Figure axesCouplingFigure(const AxesFrequencyResult& result) {
    widgets::Figure figure =
        figureOverFrequency(Words::tr("Response to the effort of another axis, relative to its own"),
                            Words::tr("relative response"), "dB");
    int colour = 0;
    for (std::size_t i = 0; i < result.axes.size(); ++i) {
        for (std::size_t j = 0; j < result.axes.size(); ++j) {
            if (i == j) {
                continue;
            }
            const devices::AxisSpec& of = result.axes[i].axis;
            const devices::AxisSpec& from = result.axes[j].axis;
            widgets::Curve curve{
                utf8(Words::tr("%1 from %2")
                         .arg(QString::fromStdString(of.id), QString::fromStdString(from.id))),
                {},
                {},
                CurveStyle::Points,
                colour++};
            const auto row = static_cast<Eigen::Index>(i);
            const auto column = static_cast<Eigen::Index>(j);
            for (const AxesFrequencyPoint& point : result.points) {
                const double size = std::abs(point.plant.value(row, column));
                if (point.isUsed[i] && size > point.plant.radius(row, column)) {
                    curve.x.push_back(hertzOf(point));
                    curve.y.push_back(decibel(size * from.effortLimit /
                                              (std::abs(point.plant.value(row, row)) * of.effortLimit)));
                }
            }
            if (!curve.x.empty()) {
                figure.panels.front().curves.push_back(std::move(curve));
            }
        }
    }
    return figure;
}

widgets::Figure axesSensitivityFigure(const AxesFrequencyResult& result) {
    widgets::Figure figure = figureOverFrequency(Words::tr("Largest singular values of all loops together"),
                                                 Words::tr("singular value"), "dB");
    widgets::Curve S{"S", {}, {}, CurveStyle::Points, 0};
    widgets::Curve T{"T", {}, {}, CurveStyle::Points, 1};
    for (const AxesFrequencyPoint& point : result.points) {
        if (point.isWhole()) {
            S.x.push_back(hertzOf(point));
            S.y.push_back(decibel(point.loop.sensitivity.value.real()));
            T.x.push_back(hertzOf(point));
            T.y.push_back(decibel(point.loop.complementary.value.real()));
        }
    }
    for (widgets::Curve* curve : {&S, &T}) {
        if (!curve->x.empty()) {
            figure.panels.front().curves.push_back(std::move(*curve));
        }
    }
    figure.panels.front().lines = {{Direction::Horizontal, 0.0, "0 dB"}};
    return figure;
}

} // namespace halbench::app
