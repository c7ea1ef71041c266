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

/// A column in degrees from `origin_rad`.
std::vector<double> degreesFrom(std::vector<double> angle_rad, double origin_rad) {
    for (double& value : angle_rad) {
        value = radiansToDegrees(value - origin_rad);
    }
    return angle_rad;
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

/// Position over reference and prediction, error, current; all angles from where the rotor was at the start.
widgets::Figure motionFigure(const Recording& recording, const std::optional<models::IdealTrace>& predicted) {
    widgets::Figure figure{"Position over reference", {"time", "s", false, {}, {}, {}}, {}};
    const std::vector<double> measured_rad =
        recording.layout ? recording.column("position") : std::vector<double>{};
    if (measured_rad.empty()) {
        return figure;
    }
    const auto& time_s = recording.time_s;
    const std::vector<double> truth_rad = recording.column("truth.position");
    const std::vector<double> reference_deg =
        degreesFrom(recording.column("reference"), measured_rad.front());
    const std::vector<double> measured_deg = degreesFrom(measured_rad, measured_rad.front());
    const std::vector<double> truth_deg =
        truth_rad.empty() ? std::vector<double>{} : degreesFrom(truth_rad, truth_rad.front());

    std::vector<Curve> positions = {{"reference", time_s, reference_deg, CurveStyle::DottedLine, 7}};
    if (predicted) {
        positions.push_back({"predicted (ideal loop)", predicted->time_s,
                             degreesFrom(predicted->angle_rad, 0.0), CurveStyle::DashedLine, 1});
    }
    positions.push_back({"measured", time_s, measured_deg, CurveStyle::Line, 0});
    appendPanel(figure, {"position", "deg", false, {}, {}, {}}, std::move(positions), 240);

    std::vector<Curve> errors = {
        {"measured error", time_s, difference(reference_deg, measured_deg), CurveStyle::Line, 0}};
    if (!truth_deg.empty()) {
        errors.push_back({"true error", time_s, difference(reference_deg, truth_deg), CurveStyle::Line, 2});
    }
    if (errors.front().y.size() == time_s.size()) {
        appendPanel(figure, {"error", "deg", false, {}, {}, {}}, std::move(errors), 140);
    }
    appendPanel(figure, {"current", "A", false, {}, {}, {}},
                {{{}, time_s, recording.column("current_command"), CurveStyle::Line, 5}}, 110);
    return figure;
}

using Cell = ReportTable::Cell;

Cell numberOf(const std::optional<double>& value, double scale, int decimals) {
    return value ? Cell{fmt::format("{:.{}f}", scale * *value, decimals)} : Cell{"\u2013", ReportTone::Muted};
}

/// Figures of several responses beside each other.
ReportTable figuresTable(const std::vector<std::pair<std::string, const MoveFigures*>>& responses) {
    ReportTable table;
    table.columns = {{"figure"}};
    for (const auto& response : responses) {
        table.columns.push_back({response.first, true});
    }
    table.columns.push_back({"unit"});
    const double degrees = radiansToDegrees(1.0);
    const auto row = [&](const char* name, const char* unit, double scale, int decimals, const auto& value) {
        std::vector<Cell> cells = {{name}};
        bool isKnown = false;
        for (const auto& response : responses) {
            const std::optional<double> number = value(*response.second);
            isKnown = isKnown || number.has_value();
            cells.push_back(numberOf(number, scale, decimals));
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
    row("final error", "\u00b0", degrees, 3, [](const MoveFigures& f) { return Number(f.finalError); });
    row("largest error, evaluated part", "\u00b0", degrees, 3,
        [](const MoveFigures& f) { return Number(f.maxError); });
    row("rms error, evaluated part", "\u00b0", degrees, 3,
        [](const MoveFigures& f) { return Number(f.rmsError); });
    row("largest error, whole run", "\u00b0", degrees, 3,
        [](const MoveFigures& f) { return Number(f.peakError); });
    row("gain", "", 1.0, 4, [](const MoveFigures& f) { return f.gain_ratio; });
    row("phase", "\u00b0", 1.0, 2, [](const MoveFigures& f) { return f.phase_deg; });
    return table;
}

/// One row a run: where it began and how it ended.
void appendRepetition(ReportSection& section, const MoveRepetition& repetition) {
    ReportTable table;
    table.caption = "Runs, each from where the rotor came to rest";
    table.columns = {{"start \u00b0", true}, {"largest error \u00b0", true}, {"peak to peak \u00b0", true}};
    for (std::size_t run = 0; run < repetition.start_rad.size(); ++run) {
        const auto cell = [](double angle_rad, int decimals) {
            return Cell{fmt::format("{:.{}f}", radiansToDegrees(angle_rad), decimals)};
        };
        table.rows.push_back({cell(repetition.start_rad[run], 2), cell(repetition.maxError_rad[run], 3),
                              cell(repetition.peakToPeak_rad[run], 3)});
    }
    if (const std::optional<double> settled_ratio = repetition.settled_ratio()) {
        section.blocks.emplace_back(ReportParagraph{fmt::format(
            "{:.0f} % of {} runs settled within {:.3g}\u00b0 where errors count.", 100.0 * *settled_ratio,
            repetition.start_rad.size(), radiansToDegrees(*repetition.config.settled_rad))});
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
    section.blocks.emplace_back(figuresTable(responses));
    widgets::Figure figure = motionFigure(result.recording, predicted);
    if (!figure.panels.empty()) {
        section.blocks.emplace_back(ReportPlot{std::move(figure), {}});
    }
    ReportFacts facts{
        {{"peak current", fmt::format("{:.3f} A", result.peakCurrent_A)},
         {"highest coil temperature", fmt::format("{:.1f} \u00b0C", result.highestTemperature_degC)}}};
    if (result.lockThreshold) {
        facts.facts.push_back({"locked means", fmt::format("error below {:.3g}\u00b0 to the end",
                                                           radiansToDegrees(*result.lockThreshold))});
    }
    section.blocks.emplace_back(std::move(facts));
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
            ReportParagraph{fmt::format("All {} values were on the board already.", asked)});
        return;
    }
    section.blocks.emplace_back(
        ReportParagraph{fmt::format("{} of {} given values were new to the board.", changes.size(), asked)});
    section.blocks.emplace_back(changeTable("Changed parameters", changes));
}

} // namespace

ReportSection moveSection(const std::string& heading, const MoveResult& result,
                          const std::optional<models::IdealTrace>& predicted,
                          const std::optional<MoveRepetition>& repetition) {
    ReportSection section{heading, {}};
    section.blocks.emplace_back(ReportQuality{result.quality});
    if (repetition) {
        appendRepetition(section, *repetition);
    }
    appendMove(section, result, predicted, std::nullopt);
    return section;
}

ReportSection applySection(const std::string& heading, const ApplyResult& result) {
    ReportSection section{heading, {}};
    section.blocks.emplace_back(result.isKept
                                    ? ReportParagraph{"The new values run on the board.", ReportTone::Good}
                                    : ReportParagraph{"The old values were restored.", ReportTone::Warn});
    section.blocks.emplace_back(ReportQuality{result.quality});
    appendChanges(section, result);
    if (result.verification) {
        appendMove(section, *result.verification, std::nullopt, result.predicted);
    }
    return section;
}

} // namespace halbench::app
