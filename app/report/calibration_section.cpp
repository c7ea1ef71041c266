#include "app/figures/calibration_figures.h"
#include "app/figures/parameter_units.h"
#include "app/report/report_blocks.h"
#include "app/report/step_sections.h"
#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::app {
namespace {

ReportTable figureTable(const std::vector<CalibrationFigure>& figures) {
    std::vector<ReportEstimate> rows;
    for (const CalibrationFigure& figure : figures) {
        const control::Estimate& estimate = figure.estimate;
        ReportEstimate row{figure.name, figure.unit, estimate.value,
                           {},          {},          control::estimateSourceName(estimate.source)};
        if (estimate.interval95) {
            row.ci95Low = estimate.interval95->first;
            row.ci95High = estimate.interval95->second;
        }
        rows.push_back(std::move(row));
    }
    return estimateTable("Found", rows);
}

ReportTable proposalTable(const CalibrateResult& result) {
    std::vector<ReportChange> changes;
    for (const ParameterValue& proposed : result.proposed) {
        const auto before =
            std::find_if(result.before.begin(), result.before.end(),
                         [&](const ParameterValue& value) { return value.name == proposed.name; });
        changes.push_back({proposed.name, parameterUnit(proposed.name),
                           before != result.before.end() ? before->value : 0.0, proposed.value});
    }
    return changeTable(result.isApplied ? "Applied to the board" : "Proposed, not applied", changes);
}

} // namespace

ReportSection calibrationSection(const std::string& heading, const CalibrateResult& result) {
    ReportSection section{heading, {}};
    section.blocks.emplace_back(ReportQuality{result.quality});
    if (!result.figures.empty()) {
        section.blocks.emplace_back(figureTable(result.figures));
    }
    if (!result.proposed.empty()) {
        section.blocks.emplace_back(proposalTable(result));
    }
    if (result.residualBefore_rad > 0.0) {
        section.blocks.emplace_back(
            ReportFacts{{{"angle error before",
                          fmt::format("{:.3f}\u00b0 rms", radiansToDegrees(result.residualBefore_rad))},
                         {"angle error after",
                          fmt::format("{:.3f}\u00b0 rms", radiansToDegrees(result.residualAfter_rad))}}});
    }
    if (!result.staticFriction.empty()) {
        section.blocks.emplace_back(ReportPlot{staticFrictionFigure(result.staticFriction), {}});
    }
    return section;
}

} // namespace halbench::app
