#include "app/cli/axis_tuning.h"
#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/cli/loop_options.h"
#include "app/cli/loop_pictures.h"
#include "app/cli/tuning_apply.h"
#include "app/cli/tuning_text.h"
#include "app/documents/filtered_gains.h"
#include "app/documents/law_code.h"
#include "app/documents/relay_document.h"
#include "app/documents/result_documents.h"
#include "app/documents/text/numbers.h"
#include "app/procedures/base/doubtful_source.h"
#include "app/tuning/gains_judgement.h"
#include "app/tuning/loop_conditions.h"
#include "devices/device_uri.h"

#include <fmt/format.h>

#include <algorithm>

namespace halbench::app {

namespace {

Result<std::optional<double>> target(const std::string& option, const std::string& text) {
    const Result<std::optional<double>> value = optionalNumber(option, text);
    if (value && value->value_or(1.0) <= 0.0) {
        return failure(ErrorCode::OutOfRange, fmt::format("{}: {} is not positive", option, text),
                       "give a positive number");
    }
    return value;
}

Result<control::DesignTargets> targetsFrom(const DesignOptions& options) {
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

/// What --gains holds is not designed. Nothing without it.
Result<std::optional<GainsFile>> gainsOf(const TuneOptions& options) {
    if (options.gainsFile.empty()) {
        return std::optional<GainsFile>();
    }
    const DesignOptions& design = options.design;
    for (const std::string* designing :
         {&design.method, &design.zeta, &design.omega, &design.bandwidth, &design.phaseMargin,
          &design.maxSensitivity, &design.currentLimit, &design.limitedStep, &design.relayFile}) {
        if (!designing->empty()) {
            return failure(ErrorCode::Usage,
                           "--gains holds the gains: --method, its targets and --relay would design others",
                           "leave out one or the other");
        }
    }
    Result<GainsFile> gains = readFilteredGains(options.gainsFile);
    return gains ? Result<std::optional<GainsFile>>(*std::move(gains)) : failure(gains.error());
}

/// Designed, or as the file has them; those are judged in the loop that they were found for.
Result<TuneResult> findGains(const TuneOptions& options, const TuningSource& source,
                             const TuneConfig& config) {
    if (!source.gains) {
        return runTune(source.estimate, config);
    }
    LoopConditions conditions = source.conditions;
    conditions.timing =
        source.device ? conditions.timing : timingOr(source.estimate.timing, source.gains->timing);
    auto judged = judgeGains(*source.gains, source.estimate, conditions, {config.seed, config.load_A});
    if (!judged) {
        return failure(judged.error().code, options.gainsFile + ": " + judged.error().message,
                       judged.error().hint);
    }
    if (const auto timing = otherTiming(source.gains->timing, conditions.timing)) {
        addOtherTiming(*judged, *timing);
    }
    const auto& motor = source.header.device;
    if (const auto foreign = motor ? foreignGains(*source.gains, *motor) : std::nullopt) {
        addFinding(*judged, *foreign);
    }
    return judged;
}

/// Method and targets, judged before anything moves.
Result<TuneConfig> tuneConfigFrom(const TuneOptions& options) {
    const Result<control::DesignTargets> targets = targetsFrom(options.design);
    const Result<std::optional<double>> load = target("--disturbance", options.outputs.load);
    const auto pictures = loopPicturesOf(options.outputs.pictures);
    if (!targets || !load || !pictures) {
        return failure(!targets ? targets.error() : !load ? load.error() : pictures.error());
    }
    TuneConfig config;
    config.load_A = load->value_or(config.load_A);
    config.method = options.design.method.empty() ? config.method : options.design.method;
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
Result<std::vector<Finding>> checkRelay(const TuneOptions& options, const TuningSource& source) {
    if (options.design.relayFile.empty()) {
        return std::vector<Finding>();
    }
    const Result<RelayFile> relay = readRelayFile(options.design.relayFile);
    if (!relay) {
        return failure(relay.error());
    }
    if (!isSameTiming(relay->timing, source.conditions.timing)) {
        return failure(
            ErrorCode::InvalidInput,
            fmt::format("--relay: {} was measured at {:.4g} s with {} samples of delay, the design is for "
                        "{:.4g} s and {}",
                        options.design.relayFile, relay->timing.period_s, relay->timing.delay_samples,
                        source.conditions.timing.period_s, source.conditions.timing.delay_samples),
            "make the experiment on the loop that is designed for");
    }
    std::vector<Finding> findings = relay->doubts;
    if (relay->header.device && source.header.device) {
        if (auto foreign = foreignMotor(relay->header.device, *source.header.device)) {
            findings.push_back(*std::move(foreign));
        }
    }
    return findings;
}

/// What the device made of the gains: for the document and as text.
struct Proof {
    bool isKept = true;
    std::optional<JsonValue> body;
    std::string text;
};

/// The verdict of `result` takes in that of the verification.
Result<Proof> proveOnDevice(CommandContext& context, const TuneOptions& options, TuningSource& source,
                            TuneResult& result) {
    const Result<AppliedGains> applied =
        options.isLive ? applyInSteps(context, source, result) : applyGains(context, source, result);
    if (!applied) {
        return failure(applied.error());
    }
    const ApplyResult& found = applied->result;
    addVerification(result.quality, found.quality);
    const char* const said = found.isKept ? "applied and verified" : "not kept, old gains restored";
    return Proof{
        found.isKept, applied->body,
        applied->steps + agreementLine(found) +
            fmt::format("{}\n{}", said, findingLines({result.quality.verdict, found.quality.findings}))};
}

/// Designs the loop of a motor: of `device`, identified now, or of the model in a file.
CommandResult tuneMotor(CommandContext& context, const TuneOptions& options, TuneConfig config,
                        std::unique_ptr<devices::Device> device) {
    if (const Result<void> fits = refuseAxis(options.axis); !fits) {
        return failure(fits.error());
    }
    Result<std::optional<GainsFile>> gains = gainsOf(options);
    if (!gains) {
        return failure(gains.error());
    }
    Result<TuningSource> source = device ? sourceFromDevice(context, options, config, std::move(device))
                                         : sourceFromFile(context, options.device);
    if (!source) {
        return failure(source.error());
    }
    source->gains = *gains;
    if (const Result<void> taken = takeCalibration(source->conditions, options.calibrationFile); !taken) {
        return failure(taken.error());
    }
    config.conditions = source->conditions;
    config.seed = source->header.seed;
    const Result<std::vector<Finding>> remarks = checkRelay(options, *source);
    if (!remarks) {
        return failure(remarks.error());
    }
    Result<TuneResult> result = findGains(options, *source, config);
    if (!result) {
        return failure(result.error());
    }
    for (const Finding& remark : *remarks) {
        addFinding(*result, remark);
    }
    const Result<void> opened = openToApply(context, options, *source, *result);
    if (!opened) {
        return failure(opened.error());
    }
    if (const auto coded = writeLaw(options.outputs.codeFile, {result->law, result->filtered},
                                    result->conditions, {result->method, source->header.device});
        !coded) {
        return failure(coded.error());
    }
    if (const auto drawn = writeLoopPictures(*loopPicturesOf(options.outputs.pictures),
                                             {&*result, &source->estimate, {}, {config.draws, config.seed}});
        !drawn) {
        return failure(drawn.error());
    }
    const std::string text = gainsText(*result); // before the verdict takes the verification in
    const Result<Proof> assessment = options.applyDevice.empty()
                                         ? Result<Proof>(Proof())
                                         : proveOnDevice(context, options, *source, *result);
    if (!assessment) {
        return failure(assessment.error());
    }
    JsonValue document = gainsDocument(source->header, *result);
    if (assessment->body) {
        document.set("applied", *assessment->body);
    }
    if (const Result<void> done = deliver(context, document, text + assessment->text, options.out); !done) {
        return failure(done.error());
    }
    return assessment->isKept ? exitCodeFor(result->quality) : ExitCode::CheckFailed;
}

CommandResult runTuneCommand(CommandContext& context, const TuneOptions& options) {
    const bool isDevice = devices::parseDeviceUri(options.device).has_value();
    const auto axes =
        isDevice ? Result<std::optional<AxisModelFile>>(std::nullopt) : axisModelIn(options.device);
    if (!axes) {
        return failure(axes.error());
    }
    if (*axes) {
        return tuneAxesOf(context, options, **axes);
    }
    Result<TuneConfig> config = tuneConfigFrom(options);
    if (!config) {
        return failure(config.error());
    }
    std::unique_ptr<devices::Device> device;
    if (isDevice) {
        auto opened = openToMove(context, options.device);
        if (!opened) {
            return failure(opened.error());
        }
        device = *std::move(opened);
    }
    if (device && device->catalogue().axes.size() > 1) {
        return tuneAxesOfDevice(context, options, std::move(device));
    }
    return tuneMotor(context, options, *std::move(config), std::move(device));
}

void addDesign(CommandSyntax& syntax, DesignOptions& options) {
    syntax.option("--method", options.method, "recommended (default), pole-placement, bandwidth ...", "M");
    syntax.option("--zeta", options.zeta, "Damping ratio", "RATIO");
    syntax.option("--omega-rad-s", options.omega, "Natural frequency", "RAD_S");
    syntax.option("--bandwidth-hz", options.bandwidth, "Bandwidth", "HZ");
    syntax.option("--phase-margin-deg", options.phaseMargin, "Phase margin", "DEG");
    syntax.option("--max-sensitivity", options.maxSensitivity,
                  "min-iae, min-itae: largest peak of the sensitivity, 1.1 to 3; default 1.7", "RATIO");
    syntax.option(
        "--current-limit-a", options.currentLimit,
        "min-iae, min-itae: current that a step of --step-deg may ask for; default the board's limit", "A");
    syntax.option("--step-deg", options.limitedStep, "min-iae, min-itae: that step; default 2", "DEG");
    syntax.option("--relay", options.relayFile, "Ziegler-Nichols: ultimate gain and period as measured",
                  "RELAY.json");
}

void addOptions(CommandSyntax& syntax, TuneOptions& options) {
    syntax.argument("MODEL.json|DEVICE", options.device, "Identified model, or a device to identify");
    addDesign(syntax, options.design);
    syntax.option("--gains", options.gainsFile, "Judge and apply these instead of designing some",
                  "GAINS.json");
    addCalibration(syntax, options.calibrationFile);
    syntax.option("--apply", options.applyDevice, "Write the gains to this device", "DEVICE");
    syntax.flag("--live", options.isLive, "With --apply: in small steps, each proved by a move");
    syntax.flag("--foreign-model", options.takesForeignModel,
                "Apply to a real device what was identified on another one");
    syntax.repeatable("--given", options.given, "Known constant when DEVICE is identified first",
                      "NAME=VALUE");
    addModelAxis(syntax, options.axis);
    syntax.option("--out", options.out, "Gains", "GAINS.json");
    addLoopOutputs(syntax, options.outputs);
}

CommandOutputs outputsOf(const TuneOptions& options) {
    CommandOutputs outputs{{options.outputs.codeFile, options.out}, {}};
    addPictureFiles(outputs, options.outputs);
    return outputs;
}

} // namespace

Command tuneCommand() {
    return makeCommand<TuneOptions>("tune", "Design gains for an identified motor",
                                    {addOptions, runTuneCommand, outputsOf});
}

} // namespace halbench::app
