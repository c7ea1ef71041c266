#include "app/actuators/actuator.h"
#include "app/cli/command_output.h"
#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/cli/frequency_options.h"
#include "app/cli/identify_options.h"
#include "app/cli/relay_options.h"
#include "app/documents/result_documents.h"
#include "app/headless/command_header.h"
#include "app/headless/recording_file.h"
#include "app/headless/recording_integrity.h"
#include "devices/formats/recording_file.h"
#include "devices/profile.h"

#include <algorithm>
#include <cmath>

namespace halbench::app {

namespace {

std::string textOf(const IdentifyResult& result) {
    std::string text;
    text += estimateLine("inertia J", result.inertia);
    text += estimateLine("viscous c", result.viscousDamping);
    text += estimateLine("Coulomb Kf", result.coulombFriction);
    text += estimateLine("torque phi", result.torqueConstant);
    for (const auto& [name, ratio] : result.ratios) {
        text += estimateLine(name, ratio);
    }
    if (result.asymmetry) {
        text += estimateLine("asymmetry", *result.asymmetry);
    }
    if (result.rSquared) {
        text += fmt::format("{:<14} {:.5f}\n", "R squared", *result.rSquared);
    }
    return text;
}

std::string textOf(const AxesIdentifyResult& result) {
    std::string text;
    for (const IdentifiedAxis& axis : result.model.axes) {
        text += estimateLine(axis.axis + " damping rate", axis.dampingRate);
        text += estimateLine(axis.axis + " gain", axis.accelerationGain);
        text += estimateLine(axis.axis + " breakaway", axis.breakawayEffort);
    }
    for (const std::vector<NamedEstimate>* list : {&result.ratios, &result.constants}) {
        for (const NamedEstimate& each : *list) {
            text += estimateLine(each.name, each.estimate);
        }
    }
    return text;
}

std::string textOf(const IdentifyOutcome& outcome) {
    return std::visit([](const auto& result) { return textOf(result); }, outcome) +
           findingLines(qualityOf(outcome));
}

CommandResult finish(CommandContext& context, const IdentifyOptions& options, const ResultHeader& header,
                     const IdentifyOutcome& outcome) {
    const JsonValue document = identificationDocument(header, outcome);
    if (const Result<void> done = deliver(context, document, textOf(outcome), options.out); !done) {
        return failure(done.error());
    }
    return exitCodeFor(qualityOf(outcome));
}

CommandResult identifyDevice(CommandContext& context, const IdentifyOptions& options) {
    const Result<std::unique_ptr<devices::Device>> device = openToMove(context, options.device);
    if (!device) {
        return failure(device.error());
    }
    const Actuator& actuator = actuatorOf((*device)->info().model);
    Result<IdentifyConfig> config = identifyConfigFrom(options.sweep, options.axis, actuator);
    if (!config) {
        return failure(config.error());
    }
    const ResultHeader header = headerFor(context, "halbench.identification/1", **device);
    config->seed = header.seed;
    const Result<IdentifyOutcome> result = actuator.identify.run(**device, *config, observerFor(context));
    if (!result) {
        return failure(result.error());
    }
    if (!options.recordFile.empty()) {
        const Result<void> written =
            writeRecording(options.recordFile, recordingOf(*result), **device, {header.started, {}, {}});
        if (!written) {
            return endWithResult(context,
                                 {identificationDocument(header, *result), textOf(*result), options.out},
                                 namingFile(options.recordFile, written).error());
        }
    }
    return finish(context, options, header, *result);
}

/// Of the board that a recording is of, as far as its sidecar says it.
Result<MeasuredTiming> recordedTiming(const devices::RecordingMeta& meta) {
    const Result<std::optional<devices::Profile>> profile = devices::findProfile(meta.device.model);
    if (!profile) {
        return failure(profile.error());
    }
    MeasuredTiming timing;
    if (*profile && (*profile)->constants.contains("T_s")) {
        timing.period_s = (*profile)->constants.at("T_s");
    }
    const auto isOfDelay = [](const auto& entry) { return entry.name == "delay.samples"; };
    const auto noted = std::find_if(meta.parameters.begin(), meta.parameters.end(), isOfDelay);
    if (noted != meta.parameters.end() && std::none_of(meta.changes.begin(), meta.changes.end(), isOfDelay)) {
        timing.delay_samples = static_cast<int>(std::lround(noted->value));
    }
    return timing;
}

/// The most that the board of a recording let flow, as far as its sidecar says it.
std::optional<double> recordedLimit_A(const devices::RecordingMeta& meta) {
    const auto isOfLimit = [](const auto& entry) { return entry.name == "limit.current"; };
    const auto noted = std::find_if(meta.parameters.begin(), meta.parameters.end(), isOfLimit);
    if (noted == meta.parameters.end() || noted->unit != "A" || !(noted->value > 0.0)) {
        return std::nullopt;
    }
    double most_A = noted->value;
    for (const devices::RecordingMeta::ParameterChange& change : meta.changes) {
        most_A = isOfLimit(change) ? std::max(most_A, change.value) : most_A;
    }
    return most_A;
}

/// The device that the sidecar names; a recording without one has none.
CommandResult identifyFile(CommandContext& context, const IdentifyOptions& options, const std::string& path) {
    Result<IdentifyConfig> config = identifyConfigFrom(options.sweep, options.axis, actuatorOf({}));
    if (!config) {
        return failure(config.error());
    }
    const auto isInterrupted = [&context] { return checkInterrupt(context); };
    const Result<devices::RecordedFile> file = devices::readRecordingFile(path, isInterrupted);
    if (!file) {
        return failure(file.error());
    }
    sayWarnings(context, file->warnings);
    ResultHeader header = headerFor(context, "halbench.identification/1");
    if (file->hasMeta) {
        header.device = file->meta.device;
        header.started = file->meta.started;
        config->recordedLimit_A = recordedLimit_A(file->meta);
    }
    config->seed = header.seed;
    const Result<MeasuredTiming> timing = file->hasMeta ? recordedTiming(file->meta) : MeasuredTiming{};
    if (!timing) {
        return failure(timing.error());
    }
    Result<IdentifyResult> result = identifyRecording(file->recording, *config, isInterrupted);
    if (!result) {
        return failure(result.error().code, path + ": " + result.error().message, result.error().hint);
    }
    result->timing = *timing;
    noteWarnings(result->quality, file->warnings);
    return finish(context, options, header, *std::move(result));
}

CommandResult runIdentifyCommand(CommandContext& context, const IdentifyOptions& options) {
    if (const Result<void> fits = checkRelayOptions(options); !fits) {
        return failure(fits.error());
    }
    const std::optional<std::string> path = recordingPath(options.device);
    if (options.isRelay) {
        return path ? failure(ErrorCode::Usage, options.device + ": a recording cannot swing",
                              "--relay needs a device")
                    : runRelayCommand(context, options);
    }
    if (const Result<void> fits = checkFrequencyOptions(options); !fits) {
        return failure(fits.error());
    }
    if (options.isFrequency) {
        return path ? failure(ErrorCode::Usage, options.device + ": a recording cannot be excited",
                              "--frequency needs a device")
                    : runFrequencyCommand(context, options);
    }
    return path ? identifyFile(context, options, *path) : identifyDevice(context, options);
}

void addSweep(CommandSyntax& syntax, IdentifyOptions& options) {
    SweepOptions& sweep = options.sweep;
    syntax.repeatable("--given", sweep.given,
                      "Known constant in SI: J, c, Kf or phi of a motor, m or Iz of a platen; repeatable",
                      "NAME=VALUE");
    syntax.option("--current-tolerance-percent", sweep.currentTolerance,
                  "Limit of the drive's gain error; default: 0.15 % at one sigma", "PERCENT");
    syntax.option("--currents", sweep.currents, "Sweep in ampere, default 1.6:4:0.2", "FROM:TO:STEP");
    syntax.option("--directions", sweep.directions, "both, forward or reverse");
    syntax.recording("--record", options.recordFile, "Recording of the sweep");
    syntax.option("--bare", sweep.bare, "Result of the same motor without the added inertia", "MODEL.json");
    syntax.option("--added-inertia", sweep.addedInertia, "Inertia added since --bare, kg*m^2", "KGM2");
}

void addFrequency(CommandSyntax& syntax, IdentifyOptions& options) {
    FrequencyOptions& frequency = options.frequency;
    syntax.flag("--frequency", options.isFrequency,
                "Measure the frequency response instead: plant, loops, margins");
    syntax.option("--excitation", frequency.excitation, "multisine (default), stepped-sine or chirp");
    syntax.option("--from-hz", frequency.from, "Lowest frequency, default 0.5, of several axes 1", "HZ");
    syntax.option("--to-hz", frequency.to, "Highest frequency, default 40, of several axes 50", "HZ");
    syntax.option("--base-rad-s", options.base, "Constant speed below the excitation, default 5", "RAD_S");
    syntax.option("--amplitude-deg", frequency.amplitude, "Of a sine of the same rms; default: what is safe",
                  "DEG");
    syntax.option("--effort-ratio", frequency.effortRatio,
                  "Of several axes: amplitude over the effort that each has, default 0.25", "RATIO");
    syntax.option("--periods", frequency.periods,
                  "That are averaged, 4 to 64, default 8; of several axes 4 to 256, default 24", "N");
    syntax.option("--coherence", frequency.coherence, "Least of a point that is used, default 0.9", "RATIO");
    syntax.option("--bode", frequency.bodeFile, "Measured responses as a table", "F.csv");
    addCalibration(syntax, frequency.calibrationFile);
}

void addRelay(CommandSyntax& syntax, IdentifyOptions& options) {
    RelayOptions& relay = options.relay;
    syntax.flag("--relay", options.isRelay,
                "The relay experiment instead: ultimate gain and period of the position loop");
    syntax.option("--model", relay.model, "Of --relay: plans it and is compared, from identify --out",
                  "MODEL.json");
    syntax.option("--relay-current", relay.current, "Height of the relay; default: what is safe", "A");
    syntax.option("--relay-gain", relay.gain,
                  "Gain where it does not saturate; default: 1.5 times the foreseen ultimate gain",
                  "A_PER_RAD");
    syntax.option("--cycles", relay.cycles, "Of --relay: measured, 40 to 400, default 100", "N");
}

void addOptions(CommandSyntax& syntax, IdentifyOptions& options) {
    syntax.argument("DEVICE|FILE.csv", options.device, "Device or recording");
    syntax.option("--axis", options.axis, "Axis of a device with several, or all; default all", "NAME");
    addSweep(syntax, options);
    syntax.option("--out", options.out, "Result", "MODEL.json");
    addFrequency(syntax, options);
    addRelay(syntax, options);
}

CommandOutputs outputsOf(const IdentifyOptions& options) {
    return {{options.frequency.bodeFile, options.out}, {options.recordFile}};
}

} // namespace

Command identifyCommand() {
    return makeCommand<IdentifyOptions>("identify", "Identify friction, damping, torque constant and inertia",
                                        {addOptions, runIdentifyCommand, outputsOf});
}

} // namespace halbench::app
