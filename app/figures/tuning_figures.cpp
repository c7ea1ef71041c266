#include "app/figures/tuning_figures.h"

#include "app/figures/coherence_panel.h"
#include "app/figures/loop_marks.h"
#include "control/base/units.h"
#include "widgets/figure/figures.h"

#include <QtCore/QCoreApplication>

#include <fmt/format.h>

#include <algorithm>
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

/// Coherent points, and behind them those that are not; nothing of a kind that there is none of.
void addMeasured(widgets::BodeContent& content, const MeasuredLoop& measured) {
    widgets::BodeContent::Response coherent{utf8(Words::tr("measured")), {},        {}, {},
                                            CurveStyle::Points,          MarkColour};
    widgets::BodeContent::Response rest{
        utf8(Words::tr("measured, low coherence")), {}, {}, {}, CurveStyle::HollowPoints, MarkColour};
    for (std::size_t i = 0; i < measured.isUsed.size(); ++i) {
        widgets::BodeContent::Response& response = measured.isUsed[i] ? coherent : rest;
        response.frequency_Hz.push_back(measured.frequency_Hz[i]);
        response.magnitude_dB.push_back(measured.magnitude_dB[i]);
        response.phase_deg.push_back(measured.phase_deg[i]);
    }
    for (widgets::BodeContent::Response* response : {&coherent, &rest}) {
        if (!response->frequency_Hz.empty()) {
            content.responses.push_back(std::move(*response));
        }
    }
}

/// How angles are written in a picture.
struct AngleScale {
    std::string symbol;
    double factor = 1.0;
    widgets::AngleUnit unit = widgets::AngleUnit::Radian;

    std::vector<double> of(const std::vector<double>& angle_rad, double start_rad = 0.0) const {
        std::vector<double> shown;
        shown.reserve(angle_rad.size());
        for (const double angle : angle_rad) {
            shown.push_back(factor * (angle - start_rad));
        }
        return shown;
    }
    std::string text(double angle_rad, int significantDigits = 3) const {
        const char* word = unit == widgets::AngleUnit::Degree ? "\u00b0" : " rad";
        return fmt::format("{:.{}g}{}", factor * angle_rad, significantDigits, word);
    }
};

AngleScale scaleOf(widgets::AngleUnit unit) {
    return {unit == widgets::AngleUnit::Degree ? "deg" : "rad", widgets::displayUnit("rad", unit).factor,
            unit};
}

/// The proposed loop last: it is drawn over the others.
std::vector<LoopCurve> proposedLast(std::vector<LoopCurve> curves) {
    std::rotate(curves.begin(), curves.begin() + 1, curves.end());
    return curves;
}

widgets::Panel angleOverCurrent(widgets::Figure& figure, const AngleScale& scale) {
    widgets::Panel current;
    current.y = {utf8(Words::tr("current")), "A", false, {}, {}, {}};
    current.height_px = 110;
    figure.x = {utf8(Words::tr("time")), "s", false, {}, {}, {}};
    widgets::Panel angle;
    angle.y = {utf8(Words::tr("angle")), scale.symbol, false, {}, {}, {}};
    figure.panels = {angle};
    return current;
}

} // namespace

widgets::Figure openLoopFigure(const AnalysisResult& predicted, const std::optional<AnalysisResult>& present,
                               const std::vector<NamedLoop>& others,
                               const std::optional<MeasuredLoop>& measured,
                               const std::optional<LoopUncertainty>& uncertainty) {
    widgets::BodeContent content;
    content.title = utf8(Words::tr("Open loop"));
    for (const LoopCurve& each : loopCurves(predicted, present, others)) {
        const auto& bode = each.loop->bode;
        const bool needsName = each.label.empty() && measured; // it is not alone any more
        const std::string label = needsName ? utf8(Words::tr("proposed")) : each.label;
        content.responses.push_back(
            {label, bode.frequency_Hz, bode.magnitude_dB, bode.phase_deg, each.style, each.colour});
    }
    if (measured) {
        addMeasured(content, *measured);
    }
    content.magnitudeLines = {{Direction::Horizontal, 0.0, "0 dB"}};
    content.phaseLines = {{Direction::Horizontal, -180.0, "\u2212180\u00b0"}};
    if (predicted.isStable) { // a factor "to the limit" would read as room that is not there
        markCrossings(content, predicted);
    }
    widgets::Figure figure = widgets::bodeFigure(content);
    if (uncertainty) {
        const control::LoopBands& bands = uncertainty->loop;
        constexpr double ToHertz = 0.5 / Pi;
        figure.panels[0].curves.push_back(bandCurve(bands.frequency_rad_s, bands.magnitude_dB, ToHertz));
        figure.panels[1].curves.push_back(bandCurve(bands.frequency_rad_s, bands.phase_deg, ToHertz));
    }
    if (measured && std::any_of(measured->coherence.begin(), measured->coherence.end(),
                                [](double each) { return std::isfinite(each); })) {
        figure.panels.push_back(coherencePanel(measured->frequency_Hz, measured->coherence, measured->isUsed,
                                               measured->leastCoherence));
    }
    return figure;
}

std::optional<widgets::Figure> linearStepFigure(const AnalysisResult& predicted,
                                                const std::optional<AnalysisResult>& present,
                                                widgets::AngleUnit unit, const std::vector<NamedLoop>& others,
                                                const std::optional<LoopUncertainty>& uncertainty) {
    if (predicted.stepCurve.time_s.empty()) {
        return std::nullopt;
    }
    const AngleScale scale = scaleOf(unit);
    widgets::Panel response;
    response.y = {utf8(Words::tr("response")), scale.symbol, false, {}, {}, {}};
    response.lines = {{Direction::Horizontal, 1.0, utf8(Words::tr("reference"))}};
    widgets::Panel current;
    current.y = {utf8(Words::tr("current")), "A", false, {}, {}, {}};
    current.height_px = 120;
    for (const LoopCurve& each : proposedLast(loopCurves(predicted, present, others))) {
        const AnalysisResult::Step& step = each.loop->stepCurve;
        if (step.time_s.empty()) {
            continue;
        }
        response.curves.push_back({each.label, step.time_s, step.response_rad, each.style, each.colour});
        current.curves.push_back({each.label, step.time_s, {}, each.style, each.colour});
        for (const double current_A : step.current_A) { // of a step of one unit: the loop is linear
            current.curves.back().y.push_back(current_A / scale.factor);
        }
    }
    if (uncertainty && uncertainty->step) {
        response.curves.push_back(bandCurve(uncertainty->step->time_s, uncertainty->step->response_rad));
    }
    return widgets::Figure{utf8(Words::tr("Predicted step of %1, linear loop")
                                    .arg(QString::fromStdString(scale.text(1.0 / scale.factor)))),
                           {utf8(Words::tr("time")), "s", false, {}, {}, {}},
                           {std::move(response), std::move(current)},
                           false,
                           true};
}

std::optional<widgets::Figure> largeStepFigure(const AnalysisResult& predicted,
                                               const std::optional<AnalysisResult>& present,
                                               widgets::AngleUnit unit, const std::vector<NamedLoop>& others,
                                               const std::optional<LoopUncertainty>& uncertainty) {
    if (!predicted.largeStep || predicted.largeStep->trace.time_s.empty()) {
        return std::nullopt;
    }
    widgets::Figure figure;
    const AngleScale scale = scaleOf(unit);
    widgets::Panel current = angleOverCurrent(figure, scale);
    widgets::Panel& angle = figure.panels.front();
    for (const LoopCurve& each : proposedLast(loopCurves(predicted, present, others))) {
        if (each.loop->largeStep) {
            const auto& trace = each.loop->largeStep->trace;
            angle.curves.push_back(
                {each.label, trace.time_s, scale.of(trace.angle_rad), each.style, each.colour});
            current.curves.push_back({each.label, trace.time_s, trace.current_A, each.style, each.colour});
        }
    }
    if (uncertainty && uncertainty->largeStep) {
        angle.curves.push_back(bandCurve(uncertainty->largeStep->time_s, uncertainty->largeStep->response_rad,
                                         1.0, scale.factor));
    }
    const double height_rad = predicted.largeStep->amplitude_rad;
    const double band_rad = predicted.frictionBand_rad;
    if (std::isfinite(band_rad) && band_rad < height_rad) {
        angle.lines = {
            {Direction::Horizontal, scale.factor * (height_rad + band_rad), utf8(Words::tr("friction band"))},
            {Direction::Horizontal, scale.factor * (height_rad - band_rad), {}}};
    }
    figure.title = fmt::format("{} {}", utf8(Words::tr("Predicted step with friction and current limit,")),
                               scale.text(height_rad));
    figure.panels.push_back(std::move(current));
    figure.isLinked = true;
    return figure;
}

namespace {

std::vector<double> difference(const std::vector<double>& one, const std::vector<double>& other) {
    std::vector<double> result;
    result.reserve(one.size());
    for (std::size_t i = 0; i < one.size() && i < other.size(); ++i) {
        result.push_back(one[i] - other[i]);
    }
    return result;
}

std::vector<double> everyMillisecond(std::size_t rows) {
    std::vector<double> time_s;
    time_s.reserve(rows);
    for (std::size_t row = 0; row < rows; ++row) {
        time_s.push_back(1e-3 * static_cast<double>(row));
    }
    return time_s;
}

/// What is left of a curve to the set-point it should reach, around zero as far as the bands matter.
widgets::Panel remainder(const VerificationBand& band, const AngleScale& scale, double end_s) {
    constexpr double Around_ratio = 2.5; // of the allowed error: what is on its way leaves the panel
    const double extent = Around_ratio * scale.factor * std::max(band.allowed_rad, band.friction_rad);
    widgets::Panel panel;
    panel.height_px = 200; // what is judged
    panel.y = {utf8(Words::tr("error")), scale.symbol, false, -extent, extent, {}};
    const auto addBand = [&](const QString& name, double half_rad, CurveStyle style, int colour) {
        const std::string label = utf8(name.arg(QString::fromStdString("\u00b1" + scale.text(half_rad, 2))));
        for (const double side : {1.0, -1.0}) {
            const double at = side * scale.factor * half_rad;
            panel.curves.push_back({label, {0.0, end_s}, {at, at}, style, colour});
        }
    };
    addBand(Words::tr("allowed %1"), band.allowed_rad, CurveStyle::DashedLine, 2);
    addBand(Words::tr("friction band %1"), band.friction_rad, CurveStyle::DottedLine, 3);
    return panel;
}

} // namespace

widgets::Figure verificationFigure(const VerificationBand& band, const Recording& measured,
                                   widgets::AngleUnit unit) {
    const AngleScale scale = scaleOf(unit);
    models::IdealTrace predicted = band.predicted;
    const double end_s = measured.time_s.empty() ? 0.0 : measured.time_s.back();
    widgets::Figure figure;
    figure.title = utf8(Words::tr("Verification move"));
    widgets::Panel current = angleOverCurrent(figure, scale);
    widgets::Panel rest = remainder(band, scale, end_s);
    widgets::Panel& angle = figure.panels.front();
    const std::string predictedWord = utf8(Words::tr("predicted"));
    const std::string measuredWord = utf8(Words::tr("measured"));
    const std::vector<double> reference = scale.of(predicted.reference_rad);
    const auto addAngle = [&](const std::string& label, const std::vector<double>& time_s,
                              std::vector<double> shown, const std::vector<double>& wanted, CurveStyle style,
                              int colour) {
        rest.curves.push_back({label, time_s, difference(wanted, shown), style, colour});
        angle.curves.push_back({label, time_s, std::move(shown), style, colour});
    };
    angle.curves.push_back(
        {utf8(Words::tr("set-point")), predicted.time_s, reference, CurveStyle::DottedLine, 7});
    addAngle(predictedWord, predicted.time_s, scale.of(predicted.angle_rad), reference,
             CurveStyle::DashedLine, 1);
    current.curves = {{predictedWord, predicted.time_s, predicted.current_A, CurveStyle::DashedLine, 1}};
    const std::vector<double> position =
        measured.layout ? measured.column("position") : std::vector<double>{};
    if (!position.empty()) {
        std::vector<double> wanted(position.size(), reference.empty() ? 0.0 : reference.back());
        addAngle(measuredWord, measured.time_s, scale.of(position, position.front()), wanted,
                 CurveStyle::Line, 0);
    }
    const std::vector<double> command =
        measured.layout ? measured.column("current_command") : std::vector<double>{};
    if (!command.empty()) {
        current.curves.push_back({measuredWord, measured.time_s, command, CurveStyle::Line, 0});
    }
    figure.panels.push_back(std::move(rest));
    figure.panels.push_back(std::move(current));
    return figure;
}

widgets::Figure recordedMoveFigure(const RecordedMove& move, widgets::AngleUnit unit) {
    const AngleScale scale = scaleOf(unit);
    const std::vector<double> time_s = everyMillisecond(move.rows());
    const std::string recordedWord = utf8(Words::tr("recorded"));
    widgets::Figure figure;
    figure.title = utf8(Words::tr("Recorded move"));
    widgets::Panel current = angleOverCurrent(figure, scale);
    widgets::Panel rest;
    rest.y = {utf8(Words::tr("error")), scale.symbol, false, {}, {}, {}};
    rest.height_px = 160;
    figure.panels[0].curves = {
        {utf8(Words::tr("set-point")), time_s, scale.of(move.reference_rad), CurveStyle::DottedLine, 7},
        {recordedWord, time_s, scale.of(move.position_rad), CurveStyle::Line, 0}};
    rest.curves = {{recordedWord, time_s, scale.of(difference(move.reference_rad, move.position_rad)),
                    CurveStyle::Line, 0}};
    current.curves = {{recordedWord, time_s, move.current_A, CurveStyle::Line, 0}};
    figure.panels.push_back(std::move(rest));
    figure.panels.push_back(std::move(current));
    return figure;
}

void addWhatIfCurves(widgets::Figure& figure, const WhatIf& whatIf, const std::optional<MotionEnvelope>& band,
                     const std::vector<double>& reference_rad, widgets::AngleUnit unit) {
    constexpr int Colour = 4;
    const AngleScale scale = scaleOf(unit);
    const std::string word = utf8(Words::tr("with the proposed gains"));
    const std::vector<double> time_s = everyMillisecond(whatIf.angle_rad.size());
    figure.panels[0].curves.push_back({word, time_s, scale.of(whatIf.angle_rad), CurveStyle::Line, Colour});
    figure.panels[1].curves.push_back(
        {word, time_s, scale.of(difference(reference_rad, whatIf.angle_rad)), CurveStyle::Line, Colour});
    figure.panels[2].curves.push_back({word, time_s, whatIf.current_A, CurveStyle::Line, Colour});
    if (band) {
        widgets::Curve area = bandCurve(band->time_s, band->angle_rad, 1.0, scale.factor);
        area.label = utf8(Words::tr("90 % band"));
        area.colour = Colour;
        figure.panels[0].curves.push_back(std::move(area));
    }
}

} // namespace halbench::app
