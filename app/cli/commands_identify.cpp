#include "app/actuators/actuator.h"
#include "app/cli/command_output.h"
#include "app/cli/command_support.h"
#include "app/cli/frequency_options.h"
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

CommandResult finish(CommandContext& context, const CommandOptions& options, const ResultHeader& header,
                     const IdentifyOutcome& outcome) {
    const JsonValue document = identificationDocument(header, outcome);
    if (const Result<void> done = deliver(context, document, identificationText(outcome), options.out);
        !done) {
        return failure(done.error());
    }
    return exitCodeFor(qualityOf(outcome));
}

CommandResult identifyDevice(CommandContext& context, const CommandOptions& options) {
    const Result<std::unique_ptr<devices::Device>> device = openToMove(context, options.device);
    if (!device) {
        return failure(device.error());
    }
    const Actuator& actuator = actuatorOf((*device)->info().model);
    Result<IdentifyConfig> config = identifyConfigFrom(options, actuator);
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
            return endWithResult(
                context, {identificationDocument(header, *result), identificationText(*result), options.out},
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
CommandResult identifyFile(CommandContext& context, const CommandOptions& options, const std::string& path) {
    Result<IdentifyConfig> config = identifyConfigFrom(options, actuatorOf({}));
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

} // namespace

CommandResult runIdentifyCommand(CommandContext& context, const CommandOptions& options) {
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

} // namespace halbench::app
