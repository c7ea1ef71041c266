#include "app/report/report_blocks.h"
#include "app/report/step_sections.h"
#include "control/base/units.h"

#include <fmt/format.h>

#include <cmath>

namespace halbench::app {
namespace {

std::optional<double> ifFinite(double value) {
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

ReportTable gainTable(const TuneResult& result, const LoopAxis& axis) {
    const control::PidGains& gains = result.law.gains;
    const std::string& effort = axis.effortUnit;
    const std::string& position = axis.positionUnit;
    std::vector<ReportQuantity> rows = {{"K_P", gains.proportional, effort + "/" + position},
                                        {"K_I", gains.integral, fmt::format("{}/({}*s)", effort, position)},
                                        {"K_D", gains.derivative, fmt::format("{}*s/{}", effort, position)}};
    if (result.filtered) {
        rows.push_back({"set-point weight b", result.filtered->proportionalWeight, ""});
        rows.push_back({"set-point weight c", result.filtered->derivativeWeight, ""});
        rows.push_back({"derivative filter", result.filtered->gains.filter_s.value_or(0.0), "s"});
    }
    return quantityTable(fmt::format("Gains of axis {} (method {})", axis.id, result.method), rows);
}

ReportTable loopTable(const TuneResult& result, const LoopAxis& axis) {
    const AnalysisResult& loop = result.predicted;
    const auto& crossover = loop.margins.gainCrossover_rad_s;
    std::vector<ReportQuantity> rows = {
        {"phase margin", ifFinite(loop.margins.phaseMargin_deg), "deg"},
        {"5th percentile of the phase margin", result.robust.phaseMargin_deg_p5, "deg"},
        {"gain margin", ifFinite(loop.margins.gainMargin_ratio), ""},
        {"delay margin", ifFinite(loop.margins.delayMargin_s), "s"},
        {"gain crossover", crossover ? std::optional(*crossover / (2.0 * Pi)) : std::nullopt, "Hz"},
        {"friction band", ifFinite(loop.frictionBand_rad), axis.positionUnit},
        {"share of unstable cases (axis uncertainty)", result.robust.unstable_fraction, ""}};
    if (loop.step) {
        rows.push_back({"rise of a small step", loop.step->riseTime_s, "s"});
        rows.push_back({"settling of a small step", loop.step->settlingTime_s, "s"});
        rows.push_back({"overshoot of a small step", loop.step->overshoot_percent, "%"});
    }
    return quantityTable(fmt::format("Sampled loop of axis {}, with the device's delay: {}", axis.id,
                                     loop.isStable ? "stable" : "unstable"),
                         rows);
}

ReportTable responseTable(const AxisResponse& response) {
    return quantityTable(
        fmt::format("Loop of axis {} while the others are closed; empty: withheld", response.axis.id),
        {{"phase margin", response.margins.phase_deg.value, "deg"},
         {"gain margin", response.margins.gain_dB.value, "dB"}});
}

std::optional<double> toldPeak(const MeasuredPeak& peak) {
    return peak.withheld == MeasuredPeak::Withheld::No ? std::optional(peak.value) : std::nullopt;
}

} // namespace

ReportSection axesFrequencySection(const std::string& heading, const AxesFrequencyResult& result) {
    ReportSection section{heading, {}};
    section.blocks.emplace_back(ReportQuality{result.quality});
    for (const AxisResponse& response : result.axes) {
        section.blocks.emplace_back(responseTable(response));
    }
    section.blocks.emplace_back(
        quantityTable("All loops together, positions in units of the test steps; empty: withheld",
                      {{"peak of the largest singular value of S", toldPeak(result.sensitivity), ""},
                       {"peak of the largest singular value of T", toldPeak(result.complementary), ""}}));
    return section;
}

ReportSection axesTuningSection(const std::string& heading, const TuneAxesResult& result) {
    ReportSection section{heading, {}};
    section.blocks.emplace_back(ReportQuality{result.quality});
    for (const TuneResult& axis : result.axes) {
        const LoopAxis& of = axis.conditions.axis.value();
        section.blocks.emplace_back(gainTable(axis, of));
        section.blocks.emplace_back(loopTable(axis, of));
    }
    if (result.joint) {
        section.blocks.emplace_back(ReportParagraph{
            fmt::format("All axes together: {:.3g} % of {} draws of the joint uncertainty are unstable.",
                        100.0 * result.joint->unstable_fraction, result.joint->draws),
            ReportTone::Plain});
    }
    return section;
}

} // namespace halbench::app
