#include "app/figures/identification_figures.h"
#include "app/report/report_blocks.h"
#include "app/report/step_sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace halbench::app {
namespace {

using control::Estimate;

ReportEstimate row(const std::string& name, const Estimate& estimate) {
    ReportEstimate result{
        name, estimate.unit, estimate.value, {}, {}, control::estimateSourceName(estimate.source)};
    if (estimate.interval95 && estimate.source == control::EstimateSource::Identified) {
        result.ci95Low = estimate.interval95->first;
        result.ci95High = estimate.interval95->second;
    }
    return result;
}

std::string ratioWords(const std::string& key) {
    static const std::map<std::string, std::string> words = {
        {"c_over_J", "c/J"},
        {"Kf_over_J", "K_f/J"},
        {"phi_over_J", "\u03c6/J"},
        {"c_over_phi", "c/\u03c6"},
        {"Kf_over_phi", "K_f/\u03c6 (friction while moving)"}};
    const auto found = words.find(key);
    return found != words.end() ? found->second : key;
}

std::string regressionCaption(const IdentifyResult& result) {
    std::string left;
    for (const SweepPoint& point : result.points) {
        if (!point.isUsed && !point.note.empty()) {
            left += fmt::format("{}{} A: {}", left.empty() ? " Left out: " : "; ",
                                reportNumber(point.current_A), point.note);
        }
    }
    std::string caption;
    if (result.rSquared && result.residualRms_rad_s) {
        caption = fmt::format("R\u00b2 = {:.4f}; residuals {:.3g} rad/s rms.", *result.rSquared,
                              *result.residualRms_rad_s);
    }
    return caption + left + (left.empty() ? "" : ".");
}

std::string correlationWords(double correlation) {
    const double shown = std::abs(correlation) < 0.005 ? 0.0 : correlation;
    return fmt::format("Correlation {:.2f}: {}", shown,
                       std::abs(correlation) < 0.5 ? "the two are known nearly independently of each other."
                                                   : "the two must be changed together to stay plausible.");
}

void appendExcitation(ReportSection& section, const Recording& recording) {
    widgets::Figure figure{"Excitation as recorded", {"time", "s", false, {}, {}, {}}, {}};
    constexpr std::array<std::array<const char*, 3>, 2> Signals = {
        {{"speed", "speed", "rad/s"}, {"current_command", "current amplitude", "A"}}};
    for (const auto& [signal, words, unit] : Signals) {
        const std::vector<double> values =
            recording.layout ? recording.column(signal) : std::vector<double>{};
        if (!values.empty()) {
            widgets::Panel panel;
            panel.y = {words, unit, false, {}, {}, {}};
            panel.height_px = 140;
            panel.curves = {{{}, recording.time_s, values, widgets::CurveStyle::Line, 0}};
            figure.panels.push_back(std::move(panel));
        }
    }
    if (!figure.panels.empty()) {
        section.blocks.emplace_back(ReportPlot{std::move(figure), {}});
    }
}

ReportFacts excitationFacts(double duration_s, const std::optional<double>& highest_degC) {
    ReportFacts facts;
    facts.addMeasured("duration of the excitation", duration_s, 1, "s");
    facts.addMeasured("highest coil temperature", highest_degC, 1, "\u00b0C");
    return facts;
}

} // namespace

ReportSection identificationSection(const std::string& heading, const IdentifyResult& result) {
    ReportSection section{heading, {}};
    section.blocks.emplace_back(ReportQuality{result.quality});
    section.blocks.emplace_back(estimateTable(
        "Parameters",
        {row("viscous damping c", result.viscousDamping), row("Coulomb friction K_f", result.coulombFriction),
         row("torque constant \u03c6", result.torqueConstant), row("inertia J", result.inertia)}));
    std::vector<ReportEstimate> ratios;
    for (const auto& [key, estimate] : result.ratios) {
        ratios.push_back(row(ratioWords(key), estimate));
    }
    if (result.asymmetry) {
        ratios.push_back(row("asymmetry of the friction", *result.asymmetry));
    }
    section.blocks.emplace_back(estimateTable("Ratios that need no given constant", ratios));
    if (auto regression = steadySpeedFigure(result)) {
        section.blocks.emplace_back(ReportPlot{*std::move(regression), regressionCaption(result)});
    }
    if (auto region = jointRegion(result)) {
        section.blocks.emplace_back(
            ReportPlot{std::move(region->figure), correlationWords(region->correlation)});
    }
    appendExcitation(section, result.recording);
    section.blocks.emplace_back(excitationFacts(result.duration_s, result.highestTemperature_degC));
    return section;
}

ReportSection axesIdentificationSection(const std::string& heading, const AxesIdentifyResult& result) {
    ReportSection section{heading, {}};
    section.blocks.emplace_back(ReportQuality{result.quality});
    for (const IdentifiedAxis& axis : result.model.axes) {
        section.blocks.emplace_back(
            estimateTable("Axis " + axis.axis, {row("damping rate", axis.dampingRate),
                                                row("acceleration per effort", axis.accelerationGain),
                                                row("friction, as effort", axis.breakawayEffort)}));
    }
    const auto addAll = [&section](const char* title, const std::vector<NamedEstimate>& estimates) {
        std::vector<ReportEstimate> rows;
        for (const NamedEstimate& each : estimates) {
            rows.push_back(row(each.title, each.estimate));
        }
        section.blocks.emplace_back(estimateTable(title, rows));
    };
    addAll("Constants", result.constants);
    addAll("Ratios that need no given constant", result.ratios);
    section.blocks.emplace_back(excitationFacts(result.duration_s, result.highestTemperature_degC));
    return section;
}

} // namespace halbench::app
