#include "app/figures/parameter_units.h"
#include "app/report/report_blocks.h"
#include "app/report/step_sections.h"
#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace halbench::app {
namespace {

using widgets::Curve;
using widgets::CurveStyle;

/// In which unit people read the positions of an axis, and how many of them one of its own units is.
struct PositionScale {
    std::string unit;   ///< in tables
    std::string symbol; ///< on axes of plots
    double perUnit = 1.0;
};

PositionScale scaleOf(const devices::AxisSpec& axis) {
    if (axis.turnsForever) {
        return {"\u00b0", "deg", radiansToDegrees(1.0)};
    }
    const std::string small = "\u00b5" + axis.positionUnit;
    return {small, small, 1e6};
}

/// A column from `origin`, in the unit of the scale.
std::vector<double> scaledFrom(std::vector<double> positions, double origin, const PositionScale& scale) {
    for (double& value : positions) {
        value = scale.perUnit * (value - origin);
    }
    return positions;
}

std::vector<double> difference(const std::vector<double>& left, const std::vector<double>& right) {
    std::vector<double> result(std::min(left.size(), right.size()));
    for (std::size_t i = 0; i < result.size(); ++i) {
        result[i] = left[i] - right[i];
    }
    return result;
}

void appendPanel(widgets::Figure& figure, widgets::Axis axis, std::vector<Curve> curves, int height_px) {
    std::erase_if(curves,
                  [](const Curve& curve) { return curve.x.empty() || curve.x.size() != curve.y.size(); });
    if (!curves.empty()) {
        figure.panels.push_back({std::move(axis), std::move(curves), {}, height_px});
    }
}

/// Position over reference and prediction, error, effort; all positions from where the axis was at the start.
/// Signals that are not called after their roles are not drawn.
widgets::Figure motionFigure(const MoveResult& result, const std::optional<models::IdealTrace>& predicted) {
    widgets::Figure figure{"Position over reference", {"time", "s", false, {}, {}, {}}, {}};
    const Recording& recording = result.recording;
    const devices::AxisRoles& roles = result.axis.roles;
    const PositionScale scale = scaleOf(result.axis);
    const std::vector<double> positions =
        recording.layout ? recording.column(roles.position) : std::vector<double>{};
    if (positions.empty()) {
        return figure;
    }
    const auto& time_s = recording.time_s;
    const std::vector<double> trueOnes = recording.column(roles.truePosition);
    const std::vector<double> reference =
        scaledFrom(recording.column(roles.reference), positions.front(), scale);
    const std::vector<double> measured = scaledFrom(positions, positions.front(), scale);
    const std::vector<double> truth =
        trueOnes.empty() ? std::vector<double>{} : scaledFrom(trueOnes, trueOnes.front(), scale);

    std::vector<Curve> curves = {{"reference", time_s, reference, CurveStyle::DottedLine, 7}};
    if (predicted) {
        curves.push_back({"predicted (ideal loop)", predicted->time_s,
                          scaledFrom(predicted->angle_rad, 0.0, scale), CurveStyle::DashedLine, 1});
    }
    curves.push_back({"measured", time_s, measured, CurveStyle::Line, 0});
    appendPanel(figure, {"position", scale.symbol, false, {}, {}, {}}, std::move(curves), 240);

    std::vector<Curve> errors = {
        {"measured error", time_s, difference(reference, measured), CurveStyle::Line, 0}};
    if (!truth.empty()) {
        errors.push_back({"true error", time_s, difference(reference, truth), CurveStyle::Line, 2});
    }
    if (errors.front().y.size() == time_s.size()) {
        appendPanel(figure, {"error", scale.symbol, false, {}, {}, {}}, std::move(errors), 140);
    }
    const bool isCurrent = result.axis.effortUnit == "A";
    appendPanel(figure, {isCurrent ? "current" : "effort", result.axis.effortUnit, false, {}, {}, {}},
                {{{}, time_s, recording.column(roles.effort), CurveStyle::Line, 5}}, 110);
    return figure;
}

using Cell = ReportTable::Cell;

Cell numberOf(const std::optional<double>& value, double scale, int decimals) {
    return value ? Cell{fmt::format("{:.{}f}", scale * *value, decimals)} : Cell{"\u2013", ReportTone::Muted};
}

/// Figures of several responses beside each other.
ReportTable figuresTable(const std::vector<std::pair<std::string, const MoveFigures*>>& responses,
                         const PositionScale& scale) {
    ReportTable table;
    table.columns = {{"figure"}};
    for (const auto& response : responses) {
        table.columns.push_back({response.first, true});
    }
    table.columns.push_back({"unit"});
    const char* const position = scale.unit.c_str();
    const auto row = [&](const char* name, const char* unit, double factor, int decimals, const auto& value) {
        std::vector<Cell> cells = {{name}};
        bool isKnown = false;
        for (const auto& response : responses) {
            const std::optional<double> number = value(*response.second);
            isKnown = isKnown || number.has_value();
            cells.push_back(numberOf(number, factor, decimals));
        }
        cells.push_back({unit, ReportTone::Muted});
        if (isKnown) {
            table.rows.push_back(std::move(cells));
        }
    };
    using Number = std::optional<double>;
    row("rise time, 10\u201390 %", "s", 1.0, 3, [](const MoveFigures& f) { return f.riseTime_s; });
    row("overshoot", "%", 1.0, 2, [](const MoveFigures& f) { return f.overshoot_percent; });
    row("peak time", "s", 1.0, 3, [](const MoveFigures& f) { return f.peakTime_s; });
    row("settling time, 2 %", "s", 1.0, 3, [](const MoveFigures& f) { return f.settlingTime_s; });
    row("locked from", "s", 1.0, 3, [](const MoveFigures& f) { return f.lockTime_s; });
    row("final error", position, scale.perUnit, 3, [](const MoveFigures& f) { return Number(f.finalError); });
    row("largest error, evaluated part", position, scale.perUnit, 3,
        [](const MoveFigures& f) { return Number(f.maxError); });
    row("rms error, evaluated part", position, scale.perUnit, 3,
        [](const MoveFigures& f) { return Number(f.rmsError); });
    row("largest error, whole run", position, scale.perUnit, 3,
        [](const MoveFigures& f) { return Number(f.peakError); });
    row("gain", "", 1.0, 4, [](const MoveFigures& f) { return f.gain_ratio; });
    row("phase", "\u00b0", 1.0, 2, [](const MoveFigures& f) { return f.phase_deg; });
    return table;
}

/// One row a run: where it began and how it ended.
void appendRepetition(ReportSection& section, const MoveRepetition& repetition, const PositionScale& scale) {
    ReportTable table;
    table.caption = "Runs, each from where the axis came to rest";
    for (const char* title : {"start ", "largest error ", "peak to peak "}) {
        table.columns.push_back({title + scale.unit, true});
    }
    table.columns.push_back({"settled after s", true});
    for (std::size_t run = 0; run < repetition.start.size(); ++run) {
        const auto cell = [&scale](double position, int decimals) {
            return Cell{fmt::format("{:.{}f}", scale.perUnit * position, decimals)};
        };
        table.rows.push_back({cell(repetition.start[run], 2), cell(repetition.maxError[run], 3),
                              cell(repetition.peakToPeak[run], 3),
                              numberOf(repetition.windowTime_s[run], 1.0, 3)});
    }
    if (const std::optional<double> settled_ratio = repetition.settled_ratio()) {
        section.blocks.emplace_back(ReportParagraph{
            fmt::format("{:.0f} % of {} runs settled within {:.3g}{}{} {}.", 100.0 * *settled_ratio,
                        repetition.start.size(), scale.perUnit * *repetition.config.settled,
                        scale.unit == "\u00b0" ? "" : " ", scale.unit,
                        repetition.settlesAfterWay ? "after the way" : "where errors count")});
    }
    if (const auto times = repetition.settlingTimes()) {
        section.blocks.emplace_back(ReportParagraph{
            fmt::format("Settling time, {} of {} runs: {:.3f} to {:.3f} s, median {:.3f} s, mean {:.3f} s "
                        "with a standard deviation of {:.3f} s.",
                        times->count, repetition.start.size(), times->least_s, times->largest_s,
                        times->median_s, times->mean_s, times->deviation_s)});
    }
    section.blocks.emplace_back(std::move(table));
}

void appendMove(ReportSection& section, const MoveResult& result,
                const std::optional<models::IdealTrace>& predicted,
                const std::optional<MoveFigures>& predictedFigures) {
    std::vector<std::pair<std::string, const MoveFigures*>> responses;
    if (result.truth) {
        responses.emplace_back("true", &*result.truth);
    }
    responses.emplace_back("measured", &result.measured);
    if (predictedFigures) {
        responses.emplace_back("predicted", &*predictedFigures);
    }
    section.blocks.emplace_back(figuresTable(responses, scaleOf(result.axis)));
    widgets::Figure figure = motionFigure(result, predicted);
    if (!figure.panels.empty()) {
        section.blocks.emplace_back(ReportPlot{std::move(figure), {}});
    }
    ReportFacts facts;
    facts.addMeasured("peak current", result.peakCurrent_A, 3, "A");
    facts.addMeasured("highest coil temperature", result.highestTemperature_degC, 1, "\u00b0C");
    for (const CrossAxisPeak& other : result.others) {
        const PositionScale scale = scaleOf(other.axis);
        facts.facts.push_back(
            {"largest distance of axis " + other.axis.id,
             fmt::format("{:.3g} {}", scale.perUnit * other.truth.value_or(other.measured), scale.unit)});
    }
    if (result.lockThreshold) {
        const PositionScale scale = scaleOf(result.axis);
        facts.facts.push_back(
            {"locked means", fmt::format("error below {:.3g}{} to the end",
                                         scale.perUnit * *result.lockThreshold, scale.unit)});
    }
    if (!facts.facts.empty()) {
        section.blocks.emplace_back(std::move(facts));
    }
}

/// Only what differs is worth a row.
void appendChanges(ReportSection& section, const ApplyResult& result) {
    std::vector<ReportChange> changes;
    for (const ParameterValue& after : result.after) {
        const auto before =
            std::find_if(result.before.begin(), result.before.end(),
                         [&](const ParameterValue& value) { return value.name == after.name; });
        const double old = before != result.before.end() ? before->value : after.value;
        changes.push_back({after.name, parameterUnit(after.name), old, after.value});
    }
    const std::size_t asked = changes.size();
    std::erase_if(changes, [](const ReportChange& change) { return !differs(change); });
    if (changes.empty()) {
        section.blocks.emplace_back(
            ReportParagraph{fmt::format("All {} values were already on the device.", asked)});
        return;
    }
    section.blocks.emplace_back(
        ReportParagraph{fmt::format("{} of {} given values were new to the device.", changes.size(), asked)});
    section.blocks.emplace_back(changeTable("Changed parameters", changes));
}

} // namespace

ReportSection moveSection(const std::string& heading, const MoveResult& result,
                          const std::optional<models::IdealTrace>& predicted,
                          const std::optional<MoveRepetition>& repetition) {
    ReportSection section{heading, {}};
    section.blocks.emplace_back(ReportQuality{result.quality});
    if (repetition) {
        appendRepetition(section, *repetition, scaleOf(result.axis));
    }
    appendMove(section, result, predicted, std::nullopt);
    return section;
}

ReportSection axesApplySection(const std::string& heading, const ApplyAxesResult& result) {
    ReportSection section{heading, {}};
    section.blocks.emplace_back(result.isKept
                                    ? ReportParagraph{"New values active on the device.", ReportTone::Good}
                                    : ReportParagraph{"Old values restored.", ReportTone::Warn});
    section.blocks.emplace_back(ReportQuality{result.quality});
    ApplyResult changed;
    changed.before = result.before;
    changed.after = result.after;
    appendChanges(section, changed);
    for (const AxisVerification& verified : result.axes) {
        const ApplyResult& assessment = verified.assessment;
        section.blocks.emplace_back(
            ReportParagraph{"Step of axis " + verified.axis.id + ":", ReportTone::Plain});
        if (assessment.verification) {
            appendMove(section, *assessment.verification,
                       assessment.band ? std::optional(assessment.band->predicted) : std::nullopt,
                       assessment.predicted);
        }
    }
    return section;
}

ReportSection applySection(const std::string& heading, const ApplyResult& result) {
    ReportSection section{heading, {}};
    section.blocks.emplace_back(result.isKept
                                    ? ReportParagraph{"New values active on the device.", ReportTone::Good}
                                    : ReportParagraph{"Old values restored.", ReportTone::Warn});
    section.blocks.emplace_back(ReportQuality{result.quality});
    appendChanges(section, result);
    if (result.verification) {
        appendMove(section, *result.verification, std::nullopt, result.predicted);
    }
    return section;
}

} // namespace halbench::app
