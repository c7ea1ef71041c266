#include "app/figures/loop_figures.h"

#include "app/figures/loop_marks.h"
#include "control/base/units.h"

#include <QtCore/QCoreApplication>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

namespace halbench::app {
namespace {

using widgets::Curve;
using widgets::CurveStyle;
using Direction = widgets::ReferenceLine::Direction;
using Complex = std::complex<double>;

/// The words of this file for the translator.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::app::LoopFigures)
};

std::string utf8(const QString& text) {
    return text.toStdString();
}

widgets::Axis frequencyAxis() {
    return {utf8(Words::tr("frequency")), "Hz", true, {}, {}, {}};
}

double decibel(double ratio) {
    return 20.0 * std::log10(ratio);
}

/// L at each frequency of the Bode diagram.
std::vector<Complex> openLoop(const AnalysisResult& loop) {
    std::vector<Complex> values;
    values.reserve(loop.bode.frequency_Hz.size());
    for (std::size_t i = 0; i < loop.bode.frequency_Hz.size(); ++i) {
        values.push_back(std::polar(std::pow(10.0, loop.bode.magnitude_dB[i] / 20.0),
                                    Pi / 180.0 * loop.bode.phase_deg[i]));
    }
    return values;
}

Curve circle(Complex centre, double radius, const std::string& label, CurveStyle style) {
    constexpr int Sides = 180;
    Curve curve{label, {}, {}, style, MarkColour};
    for (int i = 0; i <= Sides; ++i) {
        const Complex point = centre + std::polar(radius, 2.0 * Pi * i / Sides);
        curve.x.push_back(point.real());
        curve.y.push_back(point.imag());
    }
    return curve;
}

std::string marginLabel(double modulusMargin) {
    return fmt::format("{}: {:.2f} (Ms {:.2f})", utf8(Words::tr("modulus margin")), modulusMargin,
                       1.0 / modulusMargin);
}

/// |1 + L| = `distance` where magnitude and phase are the axes; phase from -360 to 0 degrees.
Curve distanceLine(double distance) {
    Curve line = circle({-1.0, 0.0}, distance, marginLabel(distance), CurveStyle::DashedLine);
    for (std::size_t i = 0; i < line.x.size(); ++i) {
        const Complex value(line.x[i], line.y[i]);
        const double phase_deg = 180.0 / Pi * std::arg(value);
        line.x[i] = phase_deg > 0.0 ? phase_deg - 360.0 : phase_deg;
        line.y[i] = decibel(std::abs(value));
    }
    return line;
}

Curve sensitivityCurve(const LoopCurve& each, bool isComplementary) {
    Curve curve{each.label, each.loop->bode.frequency_Hz, {}, each.style, each.colour};
    for (const Complex& value : openLoop(*each.loop)) {
        const double distance = std::abs(1.0 + value);
        curve.y.push_back(decibel((isComplementary ? std::abs(value) : 1.0) / distance));
    }
    return curve;
}

/// Coherent points, and behind them those that are not; nothing of a kind that there is none of. `place`:
/// where magnitude in dB and phase in degrees lie in this picture.
template <typename Place>
void addMeasured(widgets::Panel& panel, const std::optional<MeasuredLoop>& measured, Place place) {
    if (!measured) {
        return;
    }
    Curve coherent{utf8(Words::tr("measured")), {}, {}, CurveStyle::Points, MarkColour};
    Curve rest{utf8(Words::tr("measured, low coherence")), {}, {}, CurveStyle::HollowPoints, MarkColour};
    for (std::size_t i = 0; i < measured->isUsed.size(); ++i) {
        const auto [x, y] = place(measured->magnitude_dB[i], measured->phase_deg[i]);
        Curve& curve = measured->isUsed[i] ? coherent : rest;
        curve.x.push_back(x);
        curve.y.push_back(y);
        curve.parameter.push_back(measured->frequency_Hz[i]);
    }
    for (Curve* curve : {&rest, &coherent}) {
        if (!curve->x.empty()) {
            panel.curves.push_back(std::move(*curve));
        }
    }
}

} // namespace

widgets::Figure nyquistFigure(const AnalysisResult& predicted, const std::optional<AnalysisResult>& present,
                              const std::vector<NamedLoop>& others,
                              const std::optional<MeasuredLoop>& measured) {
    widgets::Figure figure;
    figure.title = utf8(Words::tr("Nyquist plot of the open loop"));
    figure.x = {utf8(Words::tr("real part of L")), {}, false, -2.5, 1.5, {}};
    widgets::Panel plane;
    plane.y = {utf8(Words::tr("imaginary part of L")), {}, false, -2.0, 1.5, {}};
    plane.height_px = 360;
    for (const LoopCurve& each : loopCurves(predicted, present, others)) {
        Curve curve{each.label, {}, {}, each.style, each.colour, false, each.loop->bode.frequency_Hz};
        for (const Complex& value : openLoop(*each.loop)) {
            curve.x.push_back(value.real());
            curve.y.push_back(value.imag());
        }
        plane.curves.push_back(std::move(curve));
    }
    addMeasured(plane, measured, [](double magnitude_dB, double phase_deg) {
        const Complex L = std::polar(std::pow(10.0, magnitude_dB / 20.0), Pi / 180.0 * phase_deg);
        return std::pair(L.real(), L.imag());
    });
    plane.curves.push_back(circle({}, 1.0, utf8(Words::tr("unit circle")), CurveStyle::DottedLine));
    if (predicted.isStable && predicted.margins.modulusMargin > 0.0) {
        const double margin = predicted.margins.modulusMargin;
        plane.curves.push_back(circle({-1.0, 0.0}, margin, marginLabel(margin), CurveStyle::DashedLine));
    }
    if (predicted.isStable) {
        appendCrossings(plane, figure.x, predicted);
    }
    plane.curves.push_back({criticalPoint(predicted), {-1.0}, {0.0}, CurveStyle::Points, MarkColour});
    figure.panels = {std::move(plane)};
    figure.isEqualScale = true;
    figure.parameter = frequencyAxis();
    return figure;
}

widgets::Figure nicholsFigure(const AnalysisResult& predicted, const std::optional<AnalysisResult>& present,
                              const std::vector<NamedLoop>& others,
                              const std::optional<MeasuredLoop>& measured) {
    constexpr double Turn_deg = 90.0;
    widgets::Panel panel;
    panel.y = {utf8(Words::tr("magnitude")), "dB", false, -40.0, 60.0, {}};
    panel.height_px = 360;
    panel.lines = {{Direction::Horizontal, 0.0, "0 dB"}, {Direction::Vertical, -180.0, {}}};
    double least_deg = -270.0;
    double most_deg = -135.0;
    for (const LoopCurve& each : loopCurves(predicted, present, others)) {
        const auto& bode = each.loop->bode;
        panel.curves.push_back({each.label, bode.phase_deg, bode.magnitude_dB, each.style, each.colour, false,
                                bode.frequency_Hz});
        for (const double phase_deg : bode.phase_deg) {
            least_deg = std::min(least_deg, phase_deg);
            most_deg = std::max(most_deg, phase_deg);
        }
    }
    addMeasured(panel, measured,
                [](double magnitude_dB, double phase_deg) { return std::pair(phase_deg, magnitude_dB); });
    for (std::size_t i = 0; measured && i < measured->phase_deg.size(); ++i) {
        least_deg = measured->isUsed[i] ? std::min(least_deg, measured->phase_deg[i]) : least_deg;
        most_deg = measured->isUsed[i] ? std::max(most_deg, measured->phase_deg[i]) : most_deg;
    }
    widgets::Figure figure;
    figure.title = utf8(Words::tr("Nichols plot of the open loop"));
    figure.x = {utf8(Words::tr("phase")),
                "deg",
                false,
                std::floor(least_deg / Turn_deg) * Turn_deg,
                std::ceil(most_deg / Turn_deg) * Turn_deg,
                0.5 * Turn_deg};
    if (predicted.isStable && predicted.margins.modulusMargin > 0.0) {
        panel.curves.push_back(distanceLine(predicted.margins.modulusMargin));
    }
    if (predicted.isStable) {
        appendNicholsCrossings(panel, figure.x, predicted);
    }
    panel.curves.push_back({"\u2212180\u00b0, 0 dB", {-180.0}, {0.0}, CurveStyle::Points, MarkColour});
    figure.panels = {std::move(panel)};
    figure.parameter = frequencyAxis();
    return figure;
}

std::optional<widgets::Figure> sensitivityFigure(const AnalysisResult& predicted,
                                                 const std::optional<AnalysisResult>& present,
                                                 const std::vector<NamedLoop>& others) {
    if (!predicted.isStable) {
        return std::nullopt;
    }
    widgets::Panel error;
    error.y = {utf8(Words::tr("sensitivity S")), "dB", false, -60.0, 20.0, {}};
    widgets::Panel response;
    response.y = {utf8(Words::tr("closed loop T")), "dB", false, -60.0, 20.0, {}};
    for (const LoopCurve& each : loopCurves(predicted, present, others)) {
        if (each.loop->isStable) {
            error.curves.push_back(sensitivityCurve(each, false));
            response.curves.push_back(sensitivityCurve(each, true));
            response.curves.back().label.clear(); // the panel above names it
        }
    }
    const double peak = 1.0 / predicted.margins.modulusMargin;
    error.lines = {{Direction::Horizontal, decibel(peak), fmt::format("Ms {:.2f}", peak)}};
    response.lines = {{Direction::Horizontal, 0.0, "0 dB"}};
    widgets::Figure figure;
    figure.title = utf8(Words::tr("Sensitivity and closed loop"));
    figure.x = frequencyAxis();
    figure.panels = {std::move(error), std::move(response)};
    figure.isLinked = true;
    return figure;
}

} // namespace halbench::app
