#include "app/experiments/run_report.h"

#include "app/actuators/htm/known_motor.h"
#include "app/documents/text/names.h"
#include "app/documents/text/numbers.h"
#include "app/figures/analysis_figure.h"
#include "app/figures/disturbance_figure.h"
#include "app/headless/exit_code.h"
#include "app/procedures/tune/disturbance.h"
#include "app/procedures/tune/position_law_parameters.h"
#include "app/report/report_blocks.h"
#include "app/report/step_sections.h"
#include "control/base/unit_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace halbench::app {

namespace {

/// The ideal loop of the same law under the same reference, where both have an ideal form.
std::optional<models::IdealTrace> idealTrace(const MoveOutcome& move,
                                             const std::optional<KnownMotor>& motor) {
    const std::optional<control::LoopReference> reference = idealReference(move.config.reference);
    if (!reference || !motor || move.result.axis.effortUnit != "A") {
        return std::nullopt;
    }
    models::IdealLoopConfig config;
    config.rotor = motor->rotor;
    config.torqueConstant_Nm_per_A = motor->torqueConstant_Nm_per_A;
    config.law = move.law;
    config.reference = *reference;
    config.duration_s = move.config.duration_s;
    return models::runIdealLoop(config);
}

ReportSection amplifierSection(const std::string& heading, const AmplifierAnalysis& result) {
    widgets::Figure figure;
    figure.title = "Current amplifier: current over voltage";
    figure.x = {"frequency", "Hz", true, {}, {}, {}};
    widgets::Panel magnitude;
    magnitude.y = {"magnitude of A/V", "dB", false, {}, {}, {}};
    magnitude.curves.push_back({"", result.frequency_Hz, result.magnitude_dB, widgets::CurveStyle::Line, {}});
    widgets::Panel phase;
    phase.y = {"phase", "deg", false, {}, {}, {}};
    phase.curves.push_back({"", result.frequency_Hz, result.phase_deg, widgets::CurveStyle::Line, {}});
    for (widgets::Panel* panel : {&magnitude, &phase}) {
        panel->lines.push_back({widgets::ReferenceLine::Direction::Vertical, 10.0, "10 Hz"});
        if (result.cutoff_Hz) {
            panel->lines.push_back({widgets::ReferenceLine::Direction::Vertical, *result.cutoff_Hz, "-3 dB"});
        }
    }
    figure.panels = {magnitude, phase};
    ReportSection section{heading, {}};
    section.blocks.emplace_back(
        quantityTable("Amplifier", {{"gain", result.gain_A_per_V, "A/V"},
                                    {"lag at 10 Hz", result.lagAt10Hz_deg, "deg"},
                                    {"-3 dB frequency", result.cutoff_Hz, "Hz"},
                                    {"phase at 1 kHz", result.phaseAt1kHz_deg, "deg"},
                                    {"loss in one shunt at the largest current", result.shuntPower_W, "W"},
                                    {"loss in each of two in parallel", result.shuntPowerEach_W, "W"}}));
    section.blocks.emplace_back(ReportPlot{figure, "Computed from the parts of the amplifier."});
    return section;
}

ReportSection recordSection(const std::string& heading, const RecordResult& result) {
    ReportSection section{heading, {}};
    section.blocks.emplace_back(ReportQuality{result.quality});
    section.blocks.emplace_back(
        ReportFacts{{{"rows", std::to_string(result.recording.rows()), ReportTone::Plain},
                     {"lost rows", std::to_string(result.recording.lostRows),
                      result.recording.lostRows > 0 ? ReportTone::Warn : ReportTone::Plain}}});
    return section;
}

ReportSection plainSection(const StepOutcome& step, const std::string& heading) {
    ReportFacts facts;
    if (const JsonValue* values = step.body.find("values")) {
        for (const JsonValue& value : values->items()) {
            facts.facts.push_back(
                {value.find("name")->text(), formatNumber(value.find("value")->number()), ReportTone::Plain});
        }
    }
    if (const JsonValue* duration = step.body.find("duration_s")) {
        facts.facts.push_back({"duration", formatNumber(duration->number()) + " s", ReportTone::Plain});
    }
    return {heading, {facts}};
}

/// What people read of an analysis, line by line, and its pictures.
ReportSection outcomeSection(const std::string& heading, const AnalysisOutcome& outcome) {
    ReportSection section{heading, {}};
    section.blocks.emplace_back(ReportQuality{outcome.quality});
    for (const std::string& line : splitList(outcome.summary, '\n')) {
        section.blocks.emplace_back(ReportParagraph{line, ReportTone::Plain});
    }
    for (const AnalysisPlot& plot : outcome.plots) {
        section.blocks.emplace_back(ReportPlot{analysisFigure(plot), plot.caption});
    }
    return section;
}

/// The same motor under the gains that ran before the first step, to be drawn beside the proposal.
struct LoopAtStart {
    std::optional<AnalysisResult> loop;
    std::optional<control::LoadStep> loaded;
};
LoopAtStart loopAtStart(const TuneOutcome& tuned, const std::vector<ParameterValue>& parametersAtStart) {
    std::map<std::string, double> values;
    for (const ParameterValue& value : parametersAtStart) {
        values.emplace(value.name, value.value);
    }
    const Result<LoopLaw> law = loopLawFromParameters(values, tuned.result.conditions.timing.period_s);
    if (!law) {
        return {};
    }
    Result<AnalysisResult> loop = runAnalysis(tuned.motor, *law, tuned.result.conditions);
    if (!loop) {
        return {};
    }
    auto loaded = disturbanceStep(tuned.motor, *law, tuned.result.conditions, *loop);
    return {*std::move(loop), std::move(loaded)};
}

ReportSection tunedSection(const std::string& heading, const TuneOutcome& tuned,
                           const std::vector<ParameterValue>& parametersAtStart) {
    const LoopAtStart before = loopAtStart(tuned, parametersAtStart);
    const TuneResult& result = tuned.result;
    std::optional<LoopUncertainty> uncertainty;
    if (auto known = loopUncertainty(tuned.motor, result.law, result.conditions, result.predicted,
                                     {TuneConfig().draws, tuned.seed})) {
        uncertainty = *std::move(known);
    }
    ReportSection section = tuningSection(heading, result, before.loop, uncertainty);
    if (const auto& disturbance = result.disturbance) {
        const control::LoadStep& loaded = disturbance->step;
        std::vector<ReportQuantity> rows = {
            {"peak of the angle", loaded.peak_rad, "rad"},
            {"recovered to a tenth of the peak after", loaded.recoveryTime_s, "s"},
            {"angle in the end", loaded.final_rad, "rad"}};
        if (const auto& band = disturbance->band) {
            rows.insert(rows.begin() + 1, {{"its 5th percentile", band->peak_rad.p5, "rad"},
                                           {"its 95th percentile", band->peak_rad.p95, "rad"}});
        }
        section.blocks.emplace_back(
            quantityTable(fmt::format("Load step equal to {} A", disturbance->load_A), rows));
        section.blocks.emplace_back(
            ReportPlot{*disturbanceFigure(loaded, before.loaded, widgets::AngleUnit::Radian,
                                          disturbance->load_A, disturbance->band),
                       "Without friction and current limit."});
    }
    return section;
}

ReportSection sectionOf(const StepOutcome& step, const std::optional<KnownMotor>& motor,
                        const std::vector<ParameterValue>& parametersAtStart) {
    const std::string heading = fmt::format("{}: {}", step.kind, step.name);
    struct Visitor {
        const StepOutcome& step;
        const std::string& heading;
        const std::optional<KnownMotor>& motor;
        const std::vector<ParameterValue>& parametersAtStart;
        ReportSection operator()(std::monostate) const { return plainSection(step, heading); }
        ReportSection operator()(const IdentifyResult& result) const {
            return identificationSection(heading, result);
        }
        ReportSection operator()(const AxesIdentifyResult& result) const {
            return axesIdentificationSection(heading, result);
        }
        ReportSection operator()(const FrequencyResult& result) const {
            return frequencySection(heading, result);
        }
        ReportSection operator()(const AxesFrequencyResult& result) const {
            return axesFrequencySection(heading, result);
        }
        ReportSection operator()(const RelayResult& result) const { return relaySection(heading, result); }
        ReportSection operator()(const CalibrateResult& result) const {
            return calibrationSection(heading, result);
        }
        ReportSection operator()(const TuneOutcome& tuned) const {
            return tunedSection(heading, tuned, parametersAtStart);
        }
        ReportSection operator()(const AnalysisResult& result) const {
            return analysisSection(heading, result);
        }
        ReportSection operator()(const AmplifierAnalysis& result) const {
            return amplifierSection(heading, result);
        }
        ReportSection operator()(const MotorAnalysis& result) const { return motorSection(heading, result); }
        ReportSection operator()(const ApplyResult& result) const { return applySection(heading, result); }
        ReportSection operator()(const MoveOutcome& move) const {
            return moveSection(heading, move.result, idealTrace(move, motor), move.repetition);
        }
        ReportSection operator()(const RecordResult& result) const { return recordSection(heading, result); }
        ReportSection operator()(const AnalysisOutcome& outcome) const {
            return outcomeSection(heading, outcome);
        }
        ReportSection operator()(const TuneAxesOutcome& tuned) const {
            return axesTuningSection(heading, tuned.result);
        }
        ReportSection operator()(const ApplyAxesResult& result) const {
            return axesApplySection(heading, result);
        }
    };
    return std::visit(Visitor{step, heading, motor, parametersAtStart}, step.detail);
}

ReportSection checksSection(const RunOutcome& outcome) {
    std::vector<ReportCheck> rows;
    ReportSection section{"Checks", {}};
    for (const CheckOutcome& check : outcome.checks) {
        rows.push_back({check.quantity, check.unit, check.value, check.min, check.max, check.passed});
    }
    section.blocks.emplace_back(checkTable(rows));
    for (const CheckOutcome& check : outcome.checks) {
        if (!check.reason.empty()) {
            section.blocks.emplace_back(
                ReportParagraph{check.quantity + ": " + check.reason, ReportTone::Muted});
        }
    }
    return section;
}

std::string overridesText(const devices::DeviceInfo& info) {
    std::string text;
    for (const auto& [key, value] : info.overrides) {
        text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", key, value);
    }
    return text.empty() ? "none" : text;
}

/// The number with its unit, or the word it stands for.
std::string parameterText(const ParameterValue& value, const devices::Catalogue& catalogue) {
    const ParameterSpec* spec = catalogue.findParameter(value.name);
    if (spec == nullptr) {
        return reportNumber(value.value);
    }
    const auto choice = static_cast<std::size_t>(std::max(value.value, 0.0));
    if (choice < spec->choices.size()) {
        return spec->choices[choice];
    }
    return fmt::format("{} {}", reportNumber(value.value), unitText(spec->unit));
}

ReportSection deviceSection(const ResultHeader& header, const RunOutcome& outcome,
                            const devices::Device& device) {
    const devices::DeviceInfo& info = device.info();
    ReportSection section{"Device", {}};
    section.blocks.emplace_back(ReportFacts{{{"model", info.model},
                                             {"identity", info.id},
                                             {"firmware", info.firmware},
                                             {"overrides", overridesText(info)},
                                             {"seed", std::to_string(header.seed)},
                                             {"transport", info.transport}}});
    section.blocks.emplace_back(ReportParagraph{"Parameters at start:", ReportTone::Plain});
    ReportFacts parameters;
    for (const ParameterValue& value : outcome.parametersAtStart) {
        parameters.facts.push_back({value.name, parameterText(value, device.catalogue()), ReportTone::Plain});
    }
    section.blocks.emplace_back(std::move(parameters));
    return section;
}

} // namespace

Result<std::string> renderRunReport(const ResultHeader& header, const Experiment& experiment,
                                    const RunOutcome& outcome, const devices::Device& device) {
    const devices::DeviceInfo& info = device.info();
    const std::optional<KnownMotor> motor = knownMotor(info);
    ReportContent content;
    content.title = experiment.title.empty() ? "Halbench run" : experiment.title;
    content.summary = experiment.description;
    content.device =
        fmt::format("{} {}, firmware {}, seed {}", info.model, info.id, info.firmware, header.seed);
    content.started = header.started;
    content.isSimulated = info.isSimulated;
    content.passed =
        outcome.checks.empty() && outcome.passed ? std::nullopt : std::optional<bool>(outcome.passed);
    if (outcome.stoppedBy) {
        content.sections.push_back(
            {"Ended early", {ReportParagraph{errorLine(*outcome.stoppedBy), ReportTone::Bad}}});
    }
    if (!outcome.checks.empty()) {
        content.sections.push_back(checksSection(outcome));
    }
    for (const StepOutcome& step : outcome.steps) {
        content.sections.push_back(sectionOf(step, motor, outcome.parametersAtStart));
    }
    if (std::optional<ReportSection> contradictions = contradictionsSection(info.model)) {
        content.sections.push_back(*std::move(contradictions));
    }
    content.sections.push_back(deviceSection(header, outcome, device));
    return renderReport(content);
}

} // namespace halbench::app
