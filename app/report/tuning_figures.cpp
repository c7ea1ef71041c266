#include "app/report/tuning_figures.h"

#include "control/base/units.h"
#include "widgets/figures.h"

#include <QtCore/QCoreApplication>

#include <fmt/format.h>

#include <cmath>

namespace halbench::app {
namespace {

using widgets::CurveStyle;
using Direction = widgets::ReferenceLine::Direction;

std::string words(const char* text) {
    return QCoreApplication::translate("halbench::app::TuningFigures", text).toStdString();
}

widgets::BodeContent::Response responseOf(const AnalysisResult& loop, const std::string& label,
                                          CurveStyle style) {
    return {label, loop.bode.frequency_Hz, loop.bode.magnitude_dB, loop.bode.phase_deg, style};
}

/// A margin is read in one panel and its crossover seen in both.
void markMargins(widgets::BodeContent& content, const control::StabilityMargins& margins) {
    if (margins.gainCrossover_rad_s) {
        const double crossover_Hz = *margins.gainCrossover_rad_s / (2.0 * Pi);
        content.magnitudeLines.push_back({Direction::Vertical, crossover_Hz, words("crossover")});
        content.phaseLines.push_back(
            {Direction::Vertical, crossover_Hz,
             fmt::format("{} {:.0f}\u00b0", words("phase margin"), margins.phaseMargin_deg)});
    }
    if (margins.phaseCrossover_rad_s && std::isfinite(margins.gainMargin_ratio)) {
        const double crossover_Hz = *margins.phaseCrossover_rad_s / (2.0 * Pi);
        content.magnitudeLines.push_back(
            {Direction::Vertical, crossover_Hz,
             fmt::format("{} {:.2g}\u00d7", words("gain margin"), margins.gainMargin_ratio)});
        content.phaseLines.push_back({Direction::Vertical, crossover_Hz, {}});
    }
}

} // namespace

widgets::Figure openLoopFigure(const AnalysisResult& predicted,
                               const std::optional<AnalysisResult>& present) {
    widgets::BodeContent content;
    content.title = words("Open loop");
    content.responses.push_back(responseOf(predicted, present ? words("proposed") : "", CurveStyle::Line));
    if (present) {
        content.responses.push_back(responseOf(*present, words("before"), CurveStyle::DashedLine));
    }
    content.magnitudeLines = {{Direction::Horizontal, 0.0, "0 dB"}};
    content.phaseLines = {{Direction::Horizontal, -180.0, "\u2212180\u00b0"}};
    markMargins(content, predicted.margins);
    return widgets::bodeFigure(content);
}

std::optional<widgets::Figure> linearStepFigure(const AnalysisResult& predicted) {
    if (predicted.stepCurve.time_s.empty()) {
        return std::nullopt;
    }
    const auto& step = predicted.stepCurve;
    widgets::Panel response;
    response.y = {words("response"), "rad", false, {}, {}, {}};
    response.curves = {{{}, step.time_s, step.response_rad, CurveStyle::Line, 0}};
    response.lines = {{Direction::Horizontal, 1.0, words("reference")}};
    widgets::Panel current;
    current.y = {words("current"), "A", false, {}, {}, {}};
    current.height_px = 120;
    current.curves = {{{}, step.time_s, step.current_A, CurveStyle::Line, 1}};
    return widgets::Figure{words("Predicted step of 1 rad, linear loop"),
                           {words("time"), "s", false, {}, {}, {}},
                           {std::move(response), std::move(current)}};
}

} // namespace halbench::app
