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

/// The words of this file for the translator.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::app::TuningFigures)
};

std::string utf8(const QString& text) {
    return text.toStdString();
}

widgets::BodeContent::Response responseOf(const AnalysisResult& loop, const std::string& label,
                                          CurveStyle style) {
    return {label, loop.bode.frequency_Hz, loop.bode.magnitude_dB, loop.bode.phase_deg, style};
}

/// A margin is read in one panel and its crossover seen in both.
void markMargins(widgets::BodeContent& content, const control::StabilityMargins& margins) {
    if (margins.gainCrossover_rad_s) {
        const double crossover_Hz = *margins.gainCrossover_rad_s / (2.0 * Pi);
        content.magnitudeLines.push_back({Direction::Vertical, crossover_Hz, {}});
        content.phaseLines.push_back(
            {Direction::Vertical, crossover_Hz,
             fmt::format("{} {:.0f}\u00b0", utf8(Words::tr("phase margin")), margins.phaseMargin_deg)});
    }
    if (margins.phaseCrossover_rad_s && std::isfinite(margins.gainMargin_ratio)) {
        const double crossover_Hz = *margins.phaseCrossover_rad_s / (2.0 * Pi);
        content.magnitudeLines.push_back(
            {Direction::Vertical, crossover_Hz,
             fmt::format("{} {:.2g}\u00d7", utf8(Words::tr("gain margin")), margins.gainMargin_ratio)});
        content.phaseLines.push_back({Direction::Vertical, crossover_Hz, {}});
    }
}

std::vector<double> inDegrees(const std::vector<double>& angle_rad, double start_rad = 0.0) {
    std::vector<double> angle_deg;
    angle_deg.reserve(angle_rad.size());
    for (const double angle : angle_rad) {
        angle_deg.push_back(radiansToDegrees(angle - start_rad));
    }
    return angle_deg;
}

widgets::Panel angleOverCurrent(widgets::Figure& figure) {
    widgets::Panel current;
    current.y = {utf8(Words::tr("current")), "A", false, {}, {}, {}};
    current.height_px = 110;
    figure.x = {utf8(Words::tr("time")), "s", false, {}, {}, {}};
    widgets::Panel angle;
    angle.y = {utf8(Words::tr("angle")), "deg", false, {}, {}, {}};
    figure.panels = {angle};
    return current;
}

} // namespace

widgets::Figure openLoopFigure(const AnalysisResult& predicted,
                               const std::optional<AnalysisResult>& present) {
    widgets::BodeContent content;
    content.title = utf8(Words::tr("Open loop"));
    content.responses.push_back(
        responseOf(predicted, present ? utf8(Words::tr("proposed")) : "", CurveStyle::Line));
    if (present) {
        content.responses.push_back(responseOf(*present, utf8(Words::tr("before")), CurveStyle::DashedLine));
    }
    content.magnitudeLines = {{Direction::Horizontal, 0.0, "0 dB"}};
    content.phaseLines = {{Direction::Horizontal, -180.0, "\u2212180\u00b0"}};
    markMargins(content, predicted.margins);
    return widgets::bodeFigure(content);
}

std::optional<widgets::Figure> linearStepFigure(const AnalysisResult& predicted,
                                                const std::optional<AnalysisResult>& present) {
    if (predicted.stepCurve.time_s.empty()) {
        return std::nullopt;
    }
    widgets::Panel response;
    response.y = {utf8(Words::tr("response")), "rad", false, {}, {}, {}};
    response.lines = {{Direction::Horizontal, 1.0, utf8(Words::tr("reference"))}};
    widgets::Panel current;
    current.y = {utf8(Words::tr("current")), "A", false, {}, {}, {}};
    current.height_px = 120;
    const auto add = [&](const AnalysisResult::Step& step, const std::string& label, CurveStyle style,
                         int colour) {
        response.curves.push_back({label, step.time_s, step.response_rad, style, colour});
        current.curves.push_back({label, step.time_s, step.current_A, style, colour});
    };
    if (present && !present->stepCurve.time_s.empty()) {
        add(present->stepCurve, utf8(Words::tr("before")), CurveStyle::DashedLine, 1);
    }
    add(predicted.stepCurve, present ? utf8(Words::tr("proposed")) : "", CurveStyle::Line, 0);
    return widgets::Figure{utf8(Words::tr("Predicted step of 1 rad, linear loop")),
                           {utf8(Words::tr("time")), "s", false, {}, {}, {}},
                           {std::move(response), std::move(current)}};
}

std::optional<widgets::Figure> largeStepFigure(const AnalysisResult& predicted,
                                               const std::optional<AnalysisResult>& present) {
    if (!predicted.largeStep || predicted.largeStep->trace.time_s.empty()) {
        return std::nullopt;
    }
    widgets::Figure figure;
    widgets::Panel current = angleOverCurrent(figure);
    widgets::Panel& angle = figure.panels.front();
    const auto add = [&](const LargeStep& step, const std::string& label, CurveStyle style, int colour) {
        angle.curves.push_back({label, step.trace.time_s, inDegrees(step.trace.angle_rad), style, colour});
        current.curves.push_back({label, step.trace.time_s, step.trace.current_A, style, colour});
    };
    if (present && present->largeStep) {
        add(*present->largeStep, utf8(Words::tr("before")), CurveStyle::DashedLine, 1);
    }
    add(*predicted.largeStep, present ? utf8(Words::tr("proposed")) : "", CurveStyle::Line, 0);
    const double height_deg = radiansToDegrees(predicted.largeStep->amplitude_rad);
    const double band_deg = radiansToDegrees(predicted.frictionBand_rad);
    if (std::isfinite(band_deg) && band_deg < height_deg) {
        angle.lines = {{Direction::Horizontal, height_deg + band_deg, utf8(Words::tr("friction band"))},
                       {Direction::Horizontal, height_deg - band_deg, {}}};
    }
    figure.title = fmt::format(
        "{} {:.0f}\u00b0", utf8(Words::tr("Predicted step with friction and current limit,")), height_deg);
    figure.panels.push_back(std::move(current));
    return figure;
}

widgets::Figure verificationFigure(const models::IdealTrace& predicted, const Recording& measured) {
    widgets::Figure figure;
    figure.title = utf8(Words::tr("Verification move"));
    widgets::Panel current = angleOverCurrent(figure);
    widgets::Panel& angle = figure.panels.front();
    angle.curves = {{utf8(Words::tr("predicted")), predicted.time_s, inDegrees(predicted.angle_rad),
                     CurveStyle::DashedLine, 1}};
    current.curves = {
        {utf8(Words::tr("predicted")), predicted.time_s, predicted.current_A, CurveStyle::DashedLine, 1}};
    const std::vector<double> position =
        measured.layout ? measured.column("position") : std::vector<double>{};
    if (!position.empty()) {
        angle.curves.push_back({utf8(Words::tr("measured")), measured.time_s,
                                inDegrees(position, position.front()), CurveStyle::Line, 0});
    }
    const std::vector<double> command =
        measured.layout ? measured.column("current_command") : std::vector<double>{};
    if (!command.empty()) {
        current.curves.push_back(
            {utf8(Words::tr("measured")), measured.time_s, command, CurveStyle::Line, 0});
    }
    figure.panels.push_back(std::move(current));
    return figure;
}

} // namespace halbench::app
