#include "app/figures/loop_figures.h"
#include "app/figures/parameter_units.h"
#include "app/figures/root_locus_figure.h"
#include "app/figures/tuning_figures.h"
#include "app/report/report_blocks.h"
#include "app/report/step_sections.h"
#include "control/base/units.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <utility>

namespace halbench::app {
namespace {

ReportTable gainTable(const control::PositionLaw& law) {
    std::vector<ReportQuantity> gains;
    for (const ParameterValue& value : lawParameters(law)) {
        gains.push_back({value.name, value.value, parameterUnit(value.name)});
    }
    return quantityTable("Gains (parallel form)", gains);
}

std::string withUnit(double value, std::string_view unit) {
    return std::isfinite(value) ? fmt::format("{:.4g}{}", value, unit) : "infinite";
}

std::string frequencyWords(const std::optional<double>& frequency_rad_s) {
    return frequency_rad_s
               ? fmt::format("{:.2f} rad/s ({:.2f} Hz)", *frequency_rad_s, *frequency_rad_s / (2.0 * Pi))
               : "none";
}

/// Two columns: now, and when given before.
ReportTable marginTable(const AnalysisResult& predicted, const std::optional<AnalysisResult>& present) {
    ReportTable table;
    table.caption = "Margins of the sampled loop with the device's delay";
    table.columns = {{"quantity"}, {present ? "proposed" : "value", true}};
    if (present) {
        table.columns.push_back({"before", true});
    }
    const auto row = [&](const std::string& name, const auto& words) {
        std::vector<ReportTable::Cell> cells = {{name}, words(predicted)};
        if (present) {
            cells.push_back(words(*present));
        }
        table.rows.push_back(std::move(cells));
    };
    using Cell = ReportTable::Cell;
    row("closed loop", [](const AnalysisResult& loop) {
        return loop.isStable ? Cell{"stable", ReportTone::Good} : Cell{"unstable", ReportTone::Bad};
    });
    row("gain margin",
        [](const AnalysisResult& loop) { return Cell{withUnit(loop.margins.gainMargin_ratio, " \u00d7")}; });
    row("phase margin",
        [](const AnalysisResult& loop) { return Cell{withUnit(loop.margins.phaseMargin_deg, "\u00b0")}; });
    row("delay margin",
        [](const AnalysisResult& loop) { return Cell{withUnit(1e3 * loop.margins.delayMargin_s, " ms")}; });
    row("modulus margin",
        [](const AnalysisResult& loop) { return Cell{withUnit(loop.margins.modulusMargin, "")}; });
    row("gain crossover",
        [](const AnalysisResult& loop) { return Cell{frequencyWords(loop.margins.gainCrossover_rad_s)}; });
    row("phase crossover",
        [](const AnalysisResult& loop) { return Cell{frequencyWords(loop.margins.phaseCrossover_rad_s)}; });
    row("largest K_P for stability", [](const AnalysisResult& loop) {
        return Cell{withUnit(loop.proportionalLimit_A_per_rad, " A/rad")};
    });
    row("friction band at rest", [](const AnalysisResult& loop) {
        return Cell{"\u00b1" + withUnit(radiansToDegrees(loop.frictionBand_rad), "\u00b0")};
    });
    row("overshoot of a large step, with friction and current limit", [](const AnalysisResult& loop) {
        const auto overshoot_percent = loop.largeStep ? loop.largeStep->overshoot_percent() : std::nullopt;
        return Cell{overshoot_percent ? fmt::format("{:.3g} % of {:.0f}\u00b0", *overshoot_percent,
                                                    radiansToDegrees(loop.largeStep->amplitude_rad))
                                      : "\u2013"};
    });
    return table;
}

ReportFacts robustFacts(const control::Robustness& robust) {
    const auto interval = [](const std::optional<control::Robustness::Interval>& spread, double factor,
                             std::string_view unit) {
        return spread ? fmt::format("{} to {}", withUnit(factor * spread->p5, unit),
                                    withUnit(factor * spread->p95, unit))
                      : "no interval is known";
    };
    return {
        {{"plants drawn from the estimate", fmt::format("{}", robust.draws)},
         {"gain margin, 5 % to 95 % of the stable ones", interval(robust.gainMargin_ratio, 1.0, " \u00d7")},
         {"phase margin, 5 % to 95 % of the stable ones", interval(robust.phaseMargin_deg, 1.0, "\u00b0")},
         {"delay margin, 5 % to 95 % of the stable ones", interval(robust.delayMargin_s, 1e3, " ms")},
         {"modulus margin, 5 % to 95 % of the stable ones", interval(robust.modulusMargin, 1.0, "")},
         {"unstable draws", fmt::format("{:.1f} %", 100.0 * robust.unstable_fraction),
          robust.unstable_fraction > 0.0 ? ReportTone::Bad : ReportTone::Plain}}};
}

void appendPredictedStep(ReportSection& section, const AnalysisResult& predicted,
                         const std::optional<AnalysisResult>& present,
                         const std::optional<LoopUncertainty>& uncertainty = std::nullopt) {
    if (auto figure = linearStepFigure(predicted, present, widgets::AngleUnit::Radian, {}, uncertainty)) {
        section.blocks.emplace_back(
            ReportPlot{*std::move(figure),
                       "Without friction and current limit: a measured step differs where these act."});
    }
}

} // namespace

ReportSection analysisSection(const std::string& heading, const AnalysisResult& result) {
    ReportSection section{heading, {}};
    section.blocks.emplace_back(ReportQuality{result.quality});
    section.blocks.emplace_back(marginTable(result, std::nullopt));
    section.blocks.emplace_back(ReportPlot{openLoopFigure(result, std::nullopt), {}});
    section.blocks.emplace_back(ReportPlot{nyquistFigure(result, std::nullopt), {}});
    section.blocks.emplace_back(ReportPlot{rootLocusFigure(result, std::nullopt), {}});
    appendPredictedStep(section, result, std::nullopt);
    return section;
}

ReportSection tuningSection(const std::string& heading, const TuneResult& result,
                            const std::optional<AnalysisResult>& present,
                            const std::optional<LoopUncertainty>& uncertainty) {
    ReportSection section{heading, {}};
    section.blocks.emplace_back(ReportParagraph{"Method: " + result.method + "."});
    section.blocks.emplace_back(ReportQuality{result.quality});
    section.blocks.emplace_back(gainTable(result.law));
    section.blocks.emplace_back(marginTable(result.predicted, present));
    section.blocks.emplace_back(robustFacts(result.robust));
    section.blocks.emplace_back(ReportPlot{openLoopFigure(result.predicted, present, {}, {}, uncertainty),
                                           uncertainty ? "Shaded: 5-95 % band (motor uncertainty)." : ""});
    section.blocks.emplace_back(ReportPlot{nyquistFigure(result.predicted, present), {}});
    section.blocks.emplace_back(ReportPlot{rootLocusFigure(result.predicted, present), {}});
    appendPredictedStep(section, result.predicted, present, uncertainty);
    return section;
}

} // namespace halbench::app
