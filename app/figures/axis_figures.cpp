#include "app/figures/axis_figures.h"

#include "app/figures/loop_curves.h"
#include "control/base/unit_text.h"

#include <QCoreApplication>

#include <utility>

namespace halbench::app {

namespace {

using widgets::CurveStyle;

struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::app::AxisFigures)
};

std::string utf8(const QString& text) {
    return text.toStdString();
}

/// Positions in mm or mrad, as the axis has m or rad.
struct PositionScale {
    std::string unit;
    double factor = 1e3;

    std::vector<double> of(const std::vector<double>& values, double from = 0.0) const {
        std::vector<double> shown;
        shown.reserve(values.size());
        for (const double value : values) {
            shown.push_back(factor * (value - from));
        }
        return shown;
    }
};

PositionScale scaleOf(const std::string& positionUnit) {
    return {"m" + positionUnit, 1e3};
}

widgets::Axis timeAxis() {
    return {utf8(Words::tr("time")), "s", false, {}, {}, {}};
}

widgets::Panel panelOf(const QString& quantity, const std::string& unit, int height_px) {
    widgets::Panel panel;
    panel.y = {utf8(quantity), unitText(unit), false, {}, {}, {}};
    panel.height_px = height_px;
    return panel;
}

constexpr int TallPanel_px = 220;
constexpr int LowPanel_px = 150;

} // namespace

std::optional<widgets::Figure> axisStepFigure(const LoopAxis& axis, const AnalysisResult& predicted,
                                              const std::optional<AnalysisResult>& present) {
    if (!predicted.largeStep || predicted.largeStep->trace.time_s.empty()) {
        return std::nullopt;
    }
    const PositionScale scale = scaleOf(axis.positionUnit);
    widgets::Panel position = panelOf(Words::tr("position"), scale.unit, TallPanel_px);
    widgets::Panel effort = panelOf(Words::tr("effort"), axis.effortUnit, LowPanel_px);
    position.lines = {{widgets::ReferenceLine::Direction::Horizontal,
                       scale.factor * predicted.largeStep->amplitude_rad, utf8(Words::tr("reference"))}};
    for (const LoopCurve& each : loopCurves(predicted, present, {})) {
        if (!each.loop->largeStep) {
            continue;
        }
        const models::IdealTrace& trace = each.loop->largeStep->trace;
        position.curves.push_back(
            {each.label, trace.time_s, scale.of(trace.angle_rad), each.style, each.colour});
        effort.curves.push_back({each.label, trace.time_s, trace.current_A, each.style, each.colour});
    }
    return widgets::Figure{utf8(Words::tr("Predicted step of axis %1").arg(QString::fromStdString(axis.id))),
                           timeAxis(),
                           {std::move(position), std::move(effort)},
                           false,
                           true};
}

std::optional<widgets::Figure> axisVerificationFigure(const AxisVerification& verified) {
    const ApplyResult& assessment = verified.assessment;
    if (!assessment.verification || !assessment.band || !assessment.verification->recording.layout) {
        return std::nullopt;
    }
    const Recording& measured = assessment.verification->recording;
    const models::IdealTrace& predicted = assessment.band->predicted;
    const PositionScale scale = scaleOf(verified.axis.positionUnit);
    const std::string predictedWord = utf8(Words::tr("predicted"));
    const std::string measuredWord = utf8(Words::tr("measured"));
    widgets::Panel position = panelOf(Words::tr("position"), scale.unit, TallPanel_px);
    widgets::Panel effort = panelOf(Words::tr("effort"), verified.axis.effortUnit, LowPanel_px);
    widgets::Panel others = panelOf(Words::tr("other axes"), {}, LowPanel_px);
    position.curves = {
        {utf8(Words::tr("reference")), predicted.time_s, scale.of(predicted.reference_rad),
         CurveStyle::DottedLine, 7},
        {predictedWord, predicted.time_s, scale.of(predicted.angle_rad), CurveStyle::DashedLine, 1}};
    effort.curves = {{predictedWord, predicted.time_s, predicted.current_A, CurveStyle::DashedLine, 1}};
    const auto add = [&](widgets::Panel& panel, const std::string& signal, const std::string& label,
                         double factor, int colour) {
        const std::vector<double> values = measured.column(signal);
        if (!values.empty()) {
            const PositionScale shown{{}, factor};
            panel.curves.push_back({label, measured.time_s,
                                    shown.of(values, factor == 1.0 ? 0.0 : values.front()), CurveStyle::Line,
                                    colour});
        }
    };
    add(position, verified.axis.roles.position, measuredWord, scale.factor, 0);
    add(effort, verified.axis.roles.effort, measuredWord, 1.0, 0);
    std::string units;
    int colour = 2;
    for (const CrossAxisPeak& other : assessment.verification->others) {
        add(others, other.axis.roles.position, other.axis.id, 1e3, colour++);
        const std::string unit = scaleOf(other.axis.positionUnit).unit;
        if (units.find(unit) == std::string::npos) {
            units += (units.empty() ? "" : ", ") + unit;
        }
    }
    others.y.unit = units;
    widgets::Figure figure{
        utf8(Words::tr("Verification step of axis %1").arg(QString::fromStdString(verified.axis.id))),
        timeAxis(),
        {std::move(position)},
        false,
        true};
    if (!others.curves.empty()) {
        figure.panels.push_back(std::move(others));
    }
    figure.panels.push_back(std::move(effort));
    return figure;
}

} // namespace halbench::app
