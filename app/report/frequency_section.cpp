#include "app/figures/frequency_figures.h"
#include "app/report/report_blocks.h"
#include "app/report/step_sections.h"
#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace halbench::app {
namespace {

ReportTable::Cell plain(std::string text) {
    return {std::move(text), ReportTone::Plain};
}

/// Value and interval, or that it is withheld; the findings say why.
std::vector<ReportTable::Cell> marginRow(const char* name, const control::MeasuredMargin& margin,
                                         const char* unit) {
    if (!margin.value) {
        return {
            plain(name), {"not given, see the findings", ReportTone::Warn}, plain("\u2013"), plain("\u2013")};
    }
    return {plain(name), plain(fmt::format("{:.2f}{}", *margin.value, unit)),
            plain(fmt::format("{:.2f} to {:.2f}{}", margin.interval->first, margin.interval->second, unit)),
            plain(fmt::format("{:.2f} Hz", *margin.frequency_rad_s / (2.0 * Pi)))};
}

ReportTable marginTable(const control::MeasuredMargins& margins) {
    ReportTable table;
    table.caption = "Margins of the measured open loop";
    table.columns = {{"margin"}, {"value", true}, {"95 % interval", true}, {"at", true}};
    table.rows = {marginRow("phase margin", margins.phase_deg, "\u00b0"),
                  marginRow("gain margin", margins.gain_dB, " dB")};
    return table;
}

ReportEstimate row(const std::string& name, const control::Estimate& estimate) {
    return {name,
            estimate.unit,
            estimate.value,
            estimate.interval95->first,
            estimate.interval95->second,
            control::estimateSourceName(estimate.source)};
}

ReportTable bandTable(const FrequencyResult& result) {
    ReportTable table;
    table.caption = fmt::format("Excitation: {}, on {:.3g} rad/s", excitationName(result.config.excitation),
                                result.turn_rad_s);
    table.columns = {{"from Hz", true}, {"to Hz", true}, {"lines", true}, {"amplitude, degrees", true}};
    for (const FrequencyBand& band : result.bands) {
        table.rows.push_back({plain(fmt::format("{:.3g}", band.from_Hz)),
                              plain(fmt::format("{:.3g}", band.to_Hz)), plain(std::to_string(band.lines)),
                              plain(fmt::format("{:.3g}", radiansToDegrees(band.amplitude_rad)))});
    }
    return table;
}

std::string useCaption(const FrequencyResult& result) {
    const auto used = std::count_if(result.points.begin(), result.points.end(),
                                    [](const FrequencyResultPoint& point) { return point.isUsed; });
    return fmt::format("{} of {} frequencies have a coherence of at least {:.3g}. The others are hollow and "
                       "not used for margins and fit.",
                       used, result.points.size(), result.config.leastCoherence);
}

ReportFacts factsOf(const FrequencyResult& result) {
    ReportFacts facts;
    facts.addMeasured("duration", result.duration_s, 1, "s");
    facts.addMeasured("minimum speed during excitation", result.lowestSpeed_rad_s, 2, "rad/s");
    facts.addMeasured("highest current", result.highestCurrent_A, 2, "A");
    facts.addMeasured("highest coil temperature", result.highestTemperature_degC, 1, "\u00b0C");
    return facts;
}

} // namespace

ReportSection frequencySection(const std::string& heading, const FrequencyResult& result) {
    ReportSection section{heading, {}};
    section.blocks.emplace_back(ReportQuality{result.quality});
    section.blocks.emplace_back(marginTable(result.margins));
    if (result.fit) {
        section.blocks.emplace_back(
            estimateTable("Fitted rotor",
                          {row("c/J", result.fit->dampingRate), row("\u03c6/J", result.fit->accelerationGain),
                           row("direct feed-through from current to angle", result.fit->feedthrough)}));
    }
    section.blocks.emplace_back(
        ReportPlot{frequencyFigure(result, FrequencyView::OpenLoop), useCaption(result)});
    section.blocks.emplace_back(ReportPlot{frequencyFigure(result, FrequencyView::Plant), {}});
    section.blocks.emplace_back(bandTable(result));
    if (auto recorded = excitationFigure(result)) {
        section.blocks.emplace_back(ReportPlot{*std::move(recorded), {}});
    }
    section.blocks.emplace_back(factsOf(result));
    return section;
}

} // namespace halbench::app
