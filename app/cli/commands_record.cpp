#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/documents/coil_documents.h"
#include "app/documents/result_header.h"
#include "app/documents/text/names.h"
#include "app/documents/text/numbers.h"
#include "app/headless/command_header.h"
#include "app/headless/reconnecting_device.h"
#include "app/headless/recording_file.h"
#include "app/headless/recording_integrity.h"
#include "app/procedures/record/capture_procedure.h"
#include "app/procedures/record/record_procedure.h"
#include "app/recordings/name_reservation.h"

#include <QtCore/QDir>
#include <QtCore/QFileInfo>

#include <fmt/format.h>

namespace halbench::app {

namespace {

struct RecordOptions {
    std::string device;
    std::string duration, rate;
    std::string signals; ///< names, separated by commas
    std::string capture; ///< likewise
    std::string trigger, preTrigger, wait;
    bool isReconnecting = false;
    std::string out, outMask;
};

/// An option that may be missing, into its place.
Result<void> readInto(double& value, const char* option, const std::string& text) {
    if (text.empty()) {
        return {};
    }
    const Result<double> number = numberOption(option, text);
    if (!number) {
        return failure(number.error());
    }
    value = *number;
    return {};
}

Result<std::optional<RecordTrigger>> recordTriggerFrom(const RecordOptions& options) {
    if (options.trigger.empty()) {
        if (!options.preTrigger.empty() || !options.wait.empty()) {
            return failure(ErrorCode::Usage, "--pre-trigger and --wait belong to --trigger or --capture",
                           "say what is waited for with --trigger SIGNAL>LEVEL");
        }
        return std::optional<RecordTrigger>();
    }
    if (options.isReconnecting) {
        return failure(ErrorCode::Usage, "--reconnect does not go with --trigger",
                       "record without a trigger, or without --reconnect");
    }
    const Result<CaptureTrigger> event = parseCaptureTrigger(options.trigger);
    if (!event) {
        return failure(event.error());
    }
    RecordTrigger trigger;
    trigger.event = *event;
    Result<void> read = readInto(trigger.preTrigger_s, "--pre-trigger", options.preTrigger);
    read = read ? readInto(trigger.patience_s, "--wait", options.wait) : read;
    return read ? Result<std::optional<RecordTrigger>>(trigger) : failure(read.error());
}

Result<RecordConfig> recordConfigFrom(const RecordOptions& options) {
    Result<std::optional<RecordTrigger>> trigger = recordTriggerFrom(options);
    if (!trigger) {
        return failure(trigger.error());
    }
    if (options.duration.empty()) {
        return failure(ErrorCode::Usage, "--duration is required", "say how long to record, in seconds");
    }
    RecordConfig config;
    config.trigger = *std::move(trigger);
    config.signals = splitList(options.signals);
    const Result<double> duration = numberOption("--duration", options.duration);
    if (!duration) {
        return failure(duration.error());
    }
    config.duration_s = *duration;
    const Result<void> rate = readInto(config.rate_Hz, "--rate", options.rate);
    if (!rate) {
        return failure(rate.error());
    }
    return config;
}

Result<CaptureConfig> captureConfigFrom(const RecordOptions& options) {
    if (options.isReconnecting) {
        return failure(ErrorCode::Usage, "--reconnect does not go with --capture",
                       "the board loses a capture when it is restarted; capture again");
    }
    if (!options.duration.empty() || !options.signals.empty()) {
        return failure(ErrorCode::Usage, "--duration and --signals do not go with --capture",
                       "a capture has 4096 rows of the signals that --capture names");
    }
    CaptureConfig config;
    config.signals = splitList(options.capture);
    const Result<CaptureTrigger> trigger = parseCaptureTrigger(options.trigger);
    if (!trigger) {
        return failure(trigger.error());
    }
    config.trigger = *trigger;
    Result<void> read = readInto(config.rate_Hz, "--rate", options.rate);
    read = read ? readInto(config.pretrigger_ratio, "--pre-trigger", options.preTrigger) : read;
    read = read ? readInto(config.patience_s, "--wait", options.wait) : read;
    return read ? Result<CaptureConfig>(std::move(config)) : failure(read.error());
}

/// The part of "FOLDER/MASK.csv" that names the file; the ending may be missing.
QString nameMaskOf(const std::string& outMask) {
    const QString mask = QFileInfo(QString::fromStdString(outMask)).fileName();
    return mask.endsWith(QLatin1String(".csv")) ? mask.chopped(4) : mask;
}

/// Where it goes. Errors: Usage, InvalidInput (the mask).
Result<void> checkOutput(const RecordOptions& options) {
    if (options.out.empty() == options.outMask.empty()) {
        return failure(ErrorCode::Usage,
                       options.out.empty() ? "--out is required" : "--out and --out-mask exclude each other",
                       "say where to with --out FILE.csv or --out-mask 'FOLDER/{device}_{number}'");
    }
    if (!options.out.empty()) {
        return {};
    }
    if (options.outMask.find("{name}") != std::string::npos) {
        return failure(ErrorCode::Usage, "--out-mask has no {name}", "write the name itself into the mask");
    }
    return checkNameMask(nameMaskOf(options.outMask));
}

struct Output {
    std::string path;
    std::string automaticName;       ///< without a mask: none
    std::unique_ptr<QLockFile> hold; ///< on it, until the file is there
};

/// `started`: the result's, so that virtual time gives equal names.
Result<Output> outputFor(const RecordOptions& options, const devices::Device& device,
                         const std::string& started) {
    if (options.outMask.empty()) {
        return Output{options.out, {}, {}};
    }
    const QFileInfo mask(QString::fromStdString(options.outMask));
    const QDateTime date = QDateTime::fromString(QString::fromStdString(started), Qt::ISODate);
    Result<ReservedName> reserved = reserveRecordingName(
        nameMaskOf(options.outMask), {recordedDevice(device.info()), {}, date}, mask.path());
    if (!reserved) {
        return failure(reserved.error());
    }
    const std::string name = reserved->name.toStdString();
    const QString file = reserved->name + QStringLiteral(".csv");
    const bool isHere = mask.path() == QLatin1String(".");
    return Output{isHere ? file.toStdString() : mask.dir().filePath(file).toStdString(), name,
                  std::move(reserved->hold)};
}

/// What is told of a recording that is complete.
struct Recorded {
    std::size_t rows = 0;
    std::uint64_t lostRows = 0;
    std::uint64_t gaps = 0;
    double gaps_s = 0.0;
    std::optional<double> trigger_s = {}; ///< of a stream that was waited for
    std::vector<CoilForecast> coils = {}; ///< at its end
};

CommandResult tell(CommandContext& context, const Output& output, const ResultHeader& header,
                   const Recorded& recorded) {
    JsonValue document = toJson(header);
    if (!output.automaticName.empty()) {
        document.set("file", output.automaticName + ".csv");
    }
    document.set("rows", static_cast<std::uint64_t>(recorded.rows))
        .set("lost_rows", recorded.lostRows)
        .set("gaps", recorded.gaps)
        .set("gaps_s", recorded.gaps_s);
    context.console.log(LogLevel::Info, fmt::format("wrote {} ({} rows)", output.path, recorded.rows));
    if (recorded.trigger_s) {
        document.set("trigger_s", *recorded.trigger_s);
        context.console.log(LogLevel::Info, fmt::format("the trigger is at {:.4g} s", *recorded.trigger_s));
    }
    if (!recorded.coils.empty()) {
        document.set("coil_forecast", toJson(recorded.coils));
        if (const std::string line = coilLine(recorded.coils); !line.empty()) {
            context.console.log(LogLevel::Info, line);
        }
    }
    for (const Finding& finding : header.quality.findings) {
        if (finding.code != RecordingIntegrityCode) { // said when it was opened
            context.console.log(LogLevel::Warning, finding.message + "; " + finding.hint);
        }
    }
    if (recorded.gaps > 0) {
        context.console.log(LogLevel::Info, fmt::format("gaps: {}, {:.3g} s together; the sidecar says where",
                                                        recorded.gaps, recorded.gaps_s));
    }
    if (const Result<void> printed = context.console.printDocument(document); !printed) {
        return failure(printed.error());
    }
    return ExitCode::Done;
}

CommandResult recordCapture(CommandContext& context, const RecordOptions& options) {
    const Result<CaptureConfig> config = captureConfigFrom(options);
    if (!config) {
        return failure(config.error());
    }
    const Result<std::unique_ptr<devices::Device>> device = openDeviceFor(context, options.device);
    if (!device) {
        return failure(device.error());
    }
    const ResultHeader header = headerFor(context, "halbench.recorded/1", **device);
    const Result<Recording> capture = runCapture(**device, *config, observerFor(context));
    if (!capture) {
        return failure(capture.error());
    }
    const Result<Output> output = outputFor(options, **device, header.started);
    if (!output) {
        return failure(output.error());
    }
    const Result<void> written = writeRecording(
        output->path, *capture, **device, {header.started, {{0.0, "trigger"}}, {}, output->automaticName});
    if (!written) {
        return failure(written.error());
    }
    return tell(context, *output, header, {capture->rows(), capture->lostRows, 0, 0.0});
}

CommandResult recordStream(CommandContext& context, const RecordOptions& options) {
    const Result<RecordConfig> config = recordConfigFrom(options);
    if (!config) {
        return failure(config.error());
    }
    Result<std::unique_ptr<devices::Device>> opened = openDeviceFor(context, options.device);
    if (!opened) {
        return failure(opened.error());
    }
    const std::unique_ptr<devices::ReturningDevice> back =
        options.isReconnecting ? reconnectingDevice(context, options.device, *std::move(opened)) : nullptr;
    devices::Device& device = back ? *back : **opened;
    ResultHeader header = headerFor(context, "halbench.recorded/1", device);
    Result<Output> place = outputFor(options, device, header.started);
    if (!place) {
        return failure(place.error());
    }
    RecordingOutput output(device, place->path, header.started, warningsTo(context.console));
    output.setAutomaticName(place->automaticName);
    if (back) {
        back->setEvents(eventsTo(warningsTo(context.console), output));
    }
    const std::optional<double> limit_degC = temperatureLimit_degC(device);
    CoilTemperatureMonitor coils(device.catalogue());
    RecordOutlet outlet = output.outlet();
    outlet.append = [&coils, &place, toFile = outlet.append](const SampleBlock& block) {
        coils.take(block);
        const auto done = toFile(block);
        place->hold.reset(); // the file has its name by now
        return done;
    };
    const Result<RecordResult> result = runRecord(device, *config, observerFor(context), &outlet);
    if (result && result->trigger_s) {
        output.addMarker(*result->trigger_s, "trigger");
    }
    const bool isCut = result && back && back->lost(); // away when the time was over
    const Result<void> done = isCut    ? failure(*back->lost())
                              : result ? output.finish()
                                       : failure(result.error());
    if (!done) {
        return failure(output.stopped(done.error()));
    }
    addQuality(header.quality, result->quality);
    return tell(context, *place, header,
                {result->rows, result->lostRows, result->gaps, result->gaps_s, result->trigger_s,
                 limit_degC ? coils.forecasts(*limit_degC) : std::vector<CoilForecast>()});
}

CommandResult runRecordCommand(CommandContext& context, const RecordOptions& options) {
    if (const Result<void> checked = checkOutput(options); !checked) {
        return failure(checked.error());
    }
    return options.capture.empty() ? recordStream(context, options) : recordCapture(context, options);
}

void addOptions(CommandSyntax& syntax, RecordOptions& options) {
    syntax.device(options.device);
    syntax.option("--duration", options.duration, "Seconds, from the trigger on; not with --capture", "S");
    syntax.option("--signals", options.signals, "Names, separated by commas", "A,B");
    syntax.option("--rate", options.rate, "Rows per second, default 100; of a capture 1000", "HZ");
    syntax.option("--capture", options.capture,
                  "The board itself records 4096 rows of 1 to 4 signals at the rate of its loop", "A,B");
    syntax.option("--trigger", options.trigger,
                  "Begin when it comes: A>LEVEL, A<LEVEL; of a capture also now (default), reference", "T");
    syntax.option("--pre-trigger", options.preTrigger,
                  "What is kept from before the trigger, in seconds; of a capture: share of its rows",
                  "S|RATIO");
    syntax.option("--wait", options.wait, "Longest wait for the trigger, default 10", "S");
    syntax.flag("--reconnect", options.isReconnecting,
                "Wait for a device that is lost and record on, with the gap marked; not with --capture");
    syntax.recording("--out", options.out, "Recording");
    syntax.option("--out-mask", options.outMask,
                  "Instead of --out: a name of its own with {device}, {date}, {time} and {number}",
                  "FOLDER/MASK");
}

CommandOutputs outputsOf(const RecordOptions& options) {
    return {{}, {options.out}};
}

} // namespace

Command recordCommand() {
    return makeCommand<RecordOptions>("record", "Record signals into a CSV file; never arms",
                                      {addOptions, runRecordCommand, outputsOf});
}

} // namespace halbench::app
