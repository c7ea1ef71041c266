#include "app/actuators/actuator.h"
#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/documents/result_documents.h"
#include "app/documents/text/numbers.h"
#include "app/documents/text/procedure_choices.h"
#include "app/headless/command_header.h"
#include "app/headless/recording_integrity.h"
#include "devices/formats/recording_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace halbench::app {

namespace {

struct CalibrateOptions {
    std::string device; ///< or FILE.csv
    std::string what;   ///< hall, stray, static-friction or all
    bool isApplied = false;
    std::string out;
};

std::string calibrationText(const CalibrateResult& result) {
    std::string text;
    for (const CalibrationFigure& figure : result.figures) {
        text += estimateLine(figure.name, figure.estimate);
    }
    text += result.isApplied ? "applied and read back:\n" : "proposed (not applied, see --apply):\n";
    for (const ParameterValue& value : result.proposed) {
        text += fmt::format("  {} = {}\n", value.name, formatNumber(value.value));
    }
    return text + findingLines(result.quality);
}

const Actuator* actuatorOfRecording(const devices::RecordedFile& file) {
    const std::span<const Actuator> rows = actuators();
    // Without a sidecar the columns decide; the first that takes recordings says which are missing.
    const auto found = std::find_if(rows.begin(), rows.end(), [&file](const Actuator& row) {
        return row.calibrateRecording != nullptr && (!file.hasMeta || row.model == file.meta.device.model);
    });
    return found == rows.end() ? nullptr : &*found;
}

CommandResult calibrateFile(CommandContext& context, const CalibrateOptions& options,
                            const std::vector<Calibration>& which, const std::string& path) {
    if (options.isApplied) {
        return failure(ErrorCode::Usage, "a recording has no device to write to",
                       "leave --apply out, or calibrate the device itself");
    }
    const auto isInterrupted = [&context] { return checkInterrupt(context); };
    const Result<devices::RecordedFile> file = devices::readRecordingFile(path, isInterrupted);
    if (!file) {
        return failure(file.error());
    }
    sayWarnings(context, file->warnings);
    const Actuator* actuator = actuatorOfRecording(*file);
    if (actuator == nullptr) {
        return failure(ErrorCode::Usage,
                       fmt::format("{}: a {} is calibrated on the device, not from a recording", path,
                                   file->meta.device.model),
                       "name the device instead");
    }
    ResultHeader header = headerFor(context, "halbench.calibration/1");
    std::vector<ParameterValue> noted;
    if (file->hasMeta) {
        header.device = file->meta.device;
        header.started = file->meta.started;
        for (const devices::RecordingMeta::ParameterNote& note : file->meta.parameters) {
            noted.push_back({note.name, note.value});
        }
    }
    CalibrateConfig config;
    config.which = which;
    Result<CalibrateResult> result =
        actuator->calibrateRecording(file->recording, noted, config, isInterrupted);
    if (!result) {
        return failure(result.error().code, path + ": " + result.error().message, result.error().hint);
    }
    noteWarnings(result->quality, file->warnings);
    const JsonValue document = calibrationDocument(header, *result);
    if (const Result<void> done = deliver(context, document, calibrationText(*result), options.out); !done) {
        return failure(done.error());
    }
    return exitCodeFor(result->quality);
}

CommandResult runCalibrateCommand(CommandContext& context, const CalibrateOptions& options) {
    const Result<std::vector<Calibration>> which = calibrationsFrom(options.what);
    if (!which) {
        return failure(which.error());
    }
    if (const std::optional<std::string> path = recordingPath(options.device)) {
        return calibrateFile(context, options, *which, *path);
    }
    const Result<std::unique_ptr<devices::Device>> device = openToMove(context, options.device);
    if (!device) {
        return failure(device.error());
    }
    if (options.isApplied) {
        if (const Result<void> kept = backUp(context, **device); !kept) {
            return failure(kept.error());
        }
    }
    const ResultHeader header = headerFor(context, "halbench.calibration/1", **device);
    CalibrateConfig config;
    config.which = *which;
    config.apply = options.isApplied;
    config.seed = header.seed;
    const CalibrateEntry& calibrate = actuatorOf((*device)->info().model).calibrate;
    const Result<CalibrateResult> result = calibrate.run(**device, config, observerFor(context));
    if (!result) {
        return failure(result.error());
    }
    const JsonValue document = calibrationDocument(header, *result);
    if (const Result<void> done = deliver(context, document, calibrationText(*result), options.out); !done) {
        return failure(done.error());
    }
    return exitCodeFor(result->quality);
}

void addOptions(CommandSyntax& syntax, CalibrateOptions& options) {
    syntax.argument("DEVICE|FILE.csv", options.device, "Device, or recording of one that senses");
    syntax.argument("WHAT", options.what, "hall, stray, static-friction or all");
    syntax.flag("--apply", options.isApplied, "Write the result to the device");
    syntax.option("--out", options.out, "Result", "CAL.json");
}

CommandOutputs outputsOf(const CalibrateOptions& options) {
    return {{options.out}, {}};
}

} // namespace

Command calibrateCommand() {
    return makeCommand<CalibrateOptions>("calibrate", "Calibrate the sensors",
                                         {addOptions, runCalibrateCommand, outputsOf});
}

} // namespace halbench::app
