#include "app/batch/command_support.h"
#include "app/batch/judgement_text.h"
#include "app/batch/law_code.h"
#include "app/batch/loop_conditions.h"
#include "app/batch/model_file.h"
#include "app/batch/numbers.h"
#include "app/batch/relay_document.h"
#include "app/batch/result_documents.h"
#include "control/base/units.h"
#include "control/design/design_targets.h"
#include "devices/device_uri.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {

namespace {

/// What `tune` starts from: a model file, or a device that it identifies first and keeps open.
struct TuningSource {
    MotorEstimate estimate;
    ResultHeader header;
    LoopConditions conditions;
    std::unique_ptr<devices::Device> device;
};

Result<TuningSource> sourceFromFile(const CommandContext& context, const std::string& path) {
    Result<ModelFile> model = readModelFile(path);
    if (!model) {
        return failure(model.error());
    }
    TuningSource source;
    source.estimate = std::move(model->estimate);
    source.header = headerFor(context, "halbench.gains/1");
    source.header.device = model->device;
    source.header.seed = context.global.seed.value_or(model->seed);
    const Result<LoopConditions> conditions = loopConditionsOf(model->device ? model->device->model : "");
    if (!conditions) {
        return failure(conditions.error());
    }
    source.conditions = *conditions;
    return source;
}

/// A target that no motor can have, or not on this board, is refused before one is moved to be identified.
Result<void> checkBeforeMotion(const TuneConfig& config, const LoopConditions& conditions) {
    const auto& methods = control::designMethods();
    const auto method = std::find_if(methods.begin(), methods.end(),
                                     [&](const auto& known) { return known.name == config.method; });
    const auto targets = targetsOnBoard(config.method, config.targets, conditions);
    return targets ? control::checkTargets(*method, conditions.timing, *targets) : failure(targets.error());
}

Result<TuningSource> sourceFromDevice(CommandContext& context, const CommandOptions& options,
                                      const TuneConfig& wanted) {
    Result<IdentifyConfig> config = identifyConfigFrom(options);
    if (!config) {
        return failure(config.error());
    }
    Result<std::unique_ptr<devices::Device>> device = openToMove(context, options.device);
    if (!device) {
        return failure(device.error());
    }
    TuningSource source;
    source.header = headerFor(context, "halbench.gains/1", **device);
    config->seed = source.header.seed;
    const Result<LoopConditions> conditions = loopConditionsOf(**device);
    if (!conditions) {
        return failure(conditions.error());
    }
    if (const Result<void> possible = checkBeforeMotion(wanted, *conditions); !possible) {
        return failure(possible.error());
    }
    source.conditions = *conditions;
    const Result<IdentifyResult> identified = runIdentify(**device, *config, observerFor(context));
    if (!identified) {
        return failure(identified.error());
    }
    source.estimate = motorEstimate(*identified);
    source.device = *std::move(device);
    return source;
}

Result<std::optional<double>> target(const std::string& option, const std::string& text) {
    const Result<std::optional<double>> value = optionalNumber(option, text);
    if (value && value->value_or(1.0) <= 0.0) {
        return failure(ErrorCode::OutOfRange, fmt::format("{}: {} is not positive", option, text),
                       "give a positive number");
    }
    return value;
}

Result<control::DesignTargets> targetsFrom(const CommandOptions& options) {
    const Result<std::optional<double>> zeta = target("--zeta", options.zeta);
    const Result<std::optional<double>> omega = target("--omega-rad-s", options.omega);
    const Result<std::optional<double>> bandwidth = target("--bandwidth-hz", options.bandwidth);
    const Result<std::optional<double>> margin = target("--phase-margin-deg", options.phaseMargin);
    const Result<std::optional<double>> sensitivity = target("--max-sensitivity", options.maxSensitivity);
    const Result<std::optional<double>> current = target("--current-limit-a", options.currentLimit);
    const Result<std::optional<double>> step = target("--step-deg", options.limitedStep);
    for (const auto* value : {&zeta, &omega, &bandwidth, &margin, &sensitivity, &current, &step}) {
        if (!*value) {
            return failure(value->error());
        }
    }
    control::DesignTargets targets{*zeta, *omega, *bandwidth, *margin, *sensitivity, *current, *step};
    if (!options.relayFile.empty()) {
        const Result<RelayFile> relay = readRelayFile(options.relayFile);
        if (!relay) {
            return failure(relay.error());
        }
        targets.ultimateGain_A_per_rad = relay->ultimateGain_A_per_rad;
        targets.ultimatePeriod_s = relay->ultimatePeriod_s;
    }
    return targets;
}

std::string boundLine(const char* name, const control::BoundUse& use, const char* unit) {
    return fmt::format("{:<26} {:.4g}{} of {:.4g}{}: {}\n", name, use.value, unit, use.bound, unit,
                       use.isActive() ? "at its bound" : "the bound is not reached");
}

/// Which of them keeps the error from being less.
std::string boundLines(const control::LeastErrorBounds& bounds) {
    std::string text = boundLine("bound on Ms", bounds.sensitivity, "");
    if (bounds.current) {
        const std::string name = fmt::format("step of {:.4g} deg", radiansToDegrees(bounds.step_rad));
        text += boundLine(name.c_str(), *bounds.current, " A");
    }
    return text;
}

std::string gainsText(const TuneResult& result) {
    std::string text = fmt::format("method {}\n", result.method);
    const JsonValue body = gainsBody(result);
    for (const JsonMember& gain : body.find("gains")->members()) {
        if (gain.value.isObject()) {
            text += fmt::format("{:<26} {:.6g} {}\n", gain.key, gain.value.find("value")->number(),
                                gain.value.find("unit")->text());
        }
    }
    const AnalysisResult& predicted = result.predicted;
    text += fmt::format("{}, gain margin {:.3g}, phase margin {:.4g} deg\n",
                        predicted.isStable ? "stable" : "UNSTABLE", predicted.margins.gainMargin_ratio,
                        predicted.margins.phaseMargin_deg);
    text += fmt::format("delay margin {:.3g} ms\n", 1e3 * predicted.margins.delayMargin_s);
    text += proofLines(result);
    text += result.bounds ? boundLines(*result.bounds) : std::string();
    return text + cycleLines(result) + intervalLines(result.robust) + loopFindingLines(result.quality, true);
}

std::string agreementLine(const ApplyResult& applied) {
    if (!applied.band || !applied.verification) {
        return {};
    }
    return fmt::format(
        "at rest {:.3g} deg from the set-point (allowed {:.3g}, friction band {:.3g}), "
        "at most {:.3g} deg off the prediction, at {:.3g} s\n",
        radiansToDegrees(std::abs(applied.verification->measured.finalError_rad)),
        radiansToDegrees(applied.band->allowed_rad), radiansToDegrees(applied.band->friction_rad),
        radiansToDegrees(std::abs(applied.band->largestOff_rad)), applied.band->largestOffTime_s);
}

/// A real device does not get the gains of another motor without a word of its user; a simulated one cannot
/// be harmed.
Result<void> admitMotor(const CommandOptions& options, const std::optional<devices::DeviceInfo>& identified,
                        const devices::DeviceInfo& device) {
    const std::optional<Finding> foreign = foreignMotor(identified, device);
    if (!foreign || device.isSimulated || options.takesForeignModel) {
        return {};
    }
    return failure(ErrorCode::ConsentMissing, "--apply: " + foreign->message,
                   foreign->hint + ", or repeat the command with --foreign-model");
}

/// The device of --apply. What it is not of this motor stands among the findings of the result.
Result<void> openToApply(CommandContext& context, const CommandOptions& options, TuningSource& source,
                         TuneResult& result) {
    if (options.applyDevice.empty() || (source.device && options.applyDevice == options.device)) {
        return {};
    }
    Result<std::unique_ptr<devices::Device>> device =
        openToMove(context, options.applyDevice, [&](const devices::DeviceInfo& opened) {
            return admitMotor(options, source.header.device, opened);
        });
    if (!device) {
        return failure(device.error());
    }
    source.device = *std::move(device);
    if (const std::optional<Finding> foreign = foreignMotor(source.header.device, source.device->info())) {
        if (!options.out.empty()) { // else it stands among what is printed
            context.console.log(LogLevel::Warning, foreign->message + "; " + foreign->hint);
        }
        result.quality.findings.push_back(*foreign);
        result.warnings.push_back(*foreign);
    }
    return {};
}

/// An apply as it is printed and written.
struct AppliedGains {
    ApplyResult result;
    JsonValue body;
    std::string steps; ///< lines about them; empty: at once
};

Result<AppliedGains> applyInSteps(CommandContext& context, TuningSource& source, const TuneResult& result) {
    if (const Result<void> kept = backUp(context, *source.device); !kept) {
        return failure(kept.error());
    }
    const Result<LoopConditions> conditions = loopConditionsOf(*source.device); // its delay, its limit
    if (!conditions) {
        return failure(conditions.error());
    }
    LiveApplyConfig config;
    config.target = result.law;
    config.motor = source.estimate;
    config.conditions = *conditions;
    config.conditions.stray = source.conditions.stray; // with its calibration
    config.draws.seed = source.header.seed;
    Result<LiveApplyResult> applied = runLiveApply(*source.device, config, observerFor(context));
    if (!applied) {
        return failure(applied.error());
    }
    const auto within = std::count_if(applied->steps.begin(), applied->steps.end(),
                                      [](const LiveStepResult& step) { return step.isWithin; });
    return AppliedGains{
        applied->apply, liveApplyBody(*applied),
        fmt::format("{} of {} steps went within the predicted band\n", within, applied->plannedSteps)};
}

Result<AppliedGains> applyGains(CommandContext& context, TuningSource& source, const TuneResult& result) {
    Result<std::vector<ParameterValue>> values = lawForDevice(result.law, source.device->catalogue());
    if (!values) {
        return failure(values.error());
    }
    if (const Result<void> kept = backUp(context, *source.device); !kept) {
        return failure(kept.error());
    }
    ApplyConfig config;
    config.values = *std::move(values);
    config.verification = stepVerification(source.estimate);
    Result<ApplyResult> applied = runApply(*source.device, config, observerFor(context));
    if (!applied) {
        return failure(applied.error());
    }
    return AppliedGains{*applied, applyBody(*applied), {}};
}

/// Method and targets, judged before anything moves.
Result<TuneConfig> tuneConfigFrom(const CommandOptions& options) {
    const Result<control::DesignTargets> targets = targetsFrom(options);
    if (!targets) {
        return failure(targets.error());
    }
    TuneConfig config;
    config.method = options.method.empty() ? config.method : options.method;
    if (options.isLive && options.applyDevice.empty()) {
        return failure(ErrorCode::Usage, "--live belongs to --apply",
                       "name the device: --apply DEVICE --live");
    }
    config.targets = *targets;
    std::vector<std::string> known;
    for (const control::DesignMethod& method : control::designMethods()) {
        known.emplace_back(method.name);
    }
    if (std::find(known.begin(), known.end(), config.method) == known.end()) {
        const auto why = control::designLaw(config.method, {1.0, 1.0, 0.0}, {}, {});
        if (why.error().code != ErrorCode::UnknownName) { // known, and not for this board
            return failure(why.error());
        }
        return failure(ErrorCode::UnknownName,
                       fmt::format("--method: '{}' is no design method", config.method),
                       fmt::format("use {}", fmt::join(known, ", ")));
    }
    return config;
}

/// The loop that swung is the one that is designed for; that it was of another motor is said.
Result<std::optional<Finding>> checkRelay(const CommandOptions& options, const TuningSource& source) {
    if (options.relayFile.empty()) {
        return std::optional<Finding>();
    }
    const Result<RelayFile> relay = readRelayFile(options.relayFile);
    if (!relay) {
        return failure(relay.error());
    }
    if (!(relay->timing == source.conditions.timing)) {
        return failure(
            ErrorCode::InvalidInput,
            fmt::format("--relay: {} was measured at {:.4g} s with {} samples of delay, the design is for "
                        "{:.4g} s and {}",
                        options.relayFile, relay->timing.period_s, relay->timing.delay_samples,
                        source.conditions.timing.period_s, source.conditions.timing.delay_samples),
            "make the experiment on the loop that is designed for");
    }
    if (!relay->header.device || !source.header.device) {
        return std::optional<Finding>();
    }
    return foreignMotor(relay->header.device, *source.header.device);
}

} // namespace

CommandResult runTuneCommand(CommandContext& context, const CommandOptions& options) {
    Result<TuneConfig> config = tuneConfigFrom(options);
    if (!config) {
        return failure(config.error());
    }
    const bool isDevice = devices::parseDeviceUri(options.device).has_value();
    Result<TuningSource> source =
        isDevice ? sourceFromDevice(context, options, *config) : sourceFromFile(context, options.device);
    if (!source) {
        return failure(source.error());
    }
    if (const Result<void> taken = takeCalibration(source->conditions, options.calibrationFile); !taken) {
        return failure(taken.error());
    }
    config->conditions = source->conditions;
    config->seed = source->header.seed;
    const Result<std::optional<Finding>> foreign = checkRelay(options, *source);
    if (!foreign) {
        return failure(foreign.error());
    }
    Result<TuneResult> result = runTune(source->estimate, *config);
    if (!result) {
        return failure(result.error());
    }
    if (*foreign) {
        result->quality.findings.push_back(**foreign);
        result->warnings.push_back(**foreign);
    }
    const Result<void> opened = openToApply(context, options, *source, *result);
    if (!opened) {
        return failure(opened.error());
    }
    if (const auto coded = writeLaw(options.codeFile, result->law, source->conditions,
                                    {result->method, source->header.device});
        !coded) {
        return failure(coded.error());
    }
    JsonValue document = gainsDocument(source->header, *result);
    std::string text = gainsText(*result);
    bool isKept = true;
    if (!options.applyDevice.empty()) {
        const Result<AppliedGains> applied =
            options.isLive ? applyInSteps(context, *source, *result) : applyGains(context, *source, *result);
        if (!applied) {
            return failure(applied.error());
        }
        isKept = applied->result.isKept;
        document.set("applied", applied->body);
        text += applied->steps + agreementLine(applied->result);
        text += fmt::format("{}\n{}", isKept ? "applied and verified" : "not kept, the old gains run again",
                            findingLines(applied->result.quality));
    }
    if (const Result<void> done = deliver(context, document, text, options.out); !done) {
        return failure(done.error());
    }
    return isKept ? exitCodeFor(result->quality) : ExitCode::CheckFailed;
}

} // namespace halbench::app
