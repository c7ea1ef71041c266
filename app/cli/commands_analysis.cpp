#include "app/analyses/analysis_settings.h"
#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/documents/text/numbers.h"
#include "app/documents/text/output_file.h"
#include "app/figures/analysis_figure.h"
#include "app/figures/picture_file.h"
#include "app/figures/recording_picture.h"
#include "app/headless/analysis_control.h"
#include "app/headless/analysis_device.h"
#include "app/headless/command_header.h"
#include "app/headless/recording_file.h"
#include "app/headless/recording_integrity.h"
#include "app/procedures/record/record_procedure.h"
#include "devices/device_uri.h"

#include <fmt/format.h>

#include <algorithm>

namespace halbench::app {

namespace {

struct AnalysisOptions {
    const Analysis* analysis;
    std::string input = {}; ///< RECORDING, SPEC or DEVICE
    std::string out = {};
    std::string picture = {};
    AnalysisTexts texts = {};
    std::string duration = {}, rate = {}, recordFile = {}; ///< of a device whose rows are taken
};

/// What the input and the options give to an analysis.
struct AnalysisInput {
    AnalysisValues values;
    std::optional<devices::RecordedFile> file;
    ResultHeader header;
};

constexpr double StandardDuration_s = 10.0;

bool takesRows(const Analysis& analysis) {
    return analysis.recording == RecordingUse::Required && analysis.device;
}

Result<void> writeOutput(CommandContext& context, const AnalysisOptions& options,
                         const AnalysisOutcome& result) {
    if (options.out.empty() || !options.analysis->writesTable || !result.table) {
        return {};
    }
    const Result<void> written = writeFile(options.out, analysisCsv(*result.table));
    if (written) {
        context.console.log(LogLevel::Info, "wrote " + options.out);
    }
    return written;
}

Result<void> checkPicture(const AnalysisOptions& options) {
    return options.picture.empty() || isPictureFile(options.picture)
               ? Result<void>()
               : failure(ErrorCode::Usage,
                         fmt::format("'{}' is of no format of pictures that can be written", options.picture),
                         "this version writes .svg, .pdf and .png");
}

Result<void> writePicture(CommandContext& context, const AnalysisOptions& options,
                          const AnalysisOutcome& result) {
    if (options.picture.empty()) {
        return {};
    }
    if (result.plots.empty()) {
        return failure(ErrorCode::Refused, "--picture: this result has no picture",
                       "leave --picture out, or choose poses along a trajectory");
    }
    const Result<std::string> content = figurePicture(analysisPicture(result.plots), options.picture);
    if (!content) {
        return failure(content.error());
    }
    const Result<void> written = writeFile(options.picture, *content);
    if (written) {
        context.console.log(LogLevel::Info, "wrote " + options.picture);
    }
    return written;
}

void addOptions(CommandSyntax& syntax, AnalysisOptions& options) {
    const Analysis& analysis = *options.analysis;
    if (analysis.recording == RecordingUse::Required) {
        syntax.argument("RECORDING", options.input,
                        analysis.device ? "Recording, or a device whose rows are recorded" : "Recording");
    } else {
        std::string help = "File of settings (.toml)";
        help += analysis.device ? ", or a device that has them" : "";
        help += analysis.recording == RecordingUse::Optional ? ", or a recording" : "";
        syntax.option("SPEC", options.input, help);
    }
    for (const AnalysisKey& key : analysis.keys) {
        const std::string name(key.name);
        const std::string help(key.help);
        if (key.type == AnalysisKeyType::Flag) {
            syntax.flag(optionOf(key), options.texts.flags[name], help);
        } else {
            syntax.option(optionOf(key), options.texts.values[name], help,
                          key.choices.empty() ? "VALUE" : std::string(key.choices));
        }
    }
    if (takesRows(analysis)) {
        syntax.option("--duration", options.duration, "Of a device: how long it is recorded; default 10",
                      "S");
        syntax.option("--rate", options.rate, "Of a device: rows per second; default 100", "HZ");
        syntax.recording("--record", options.recordFile, "Of a device: recording of its rows");
    }
    syntax.option("--out", options.out, analysis.writesTable ? "Table" : "Result",
                  analysis.writesTable ? "FILE.csv" : "FILE.json");
    if (analysis.hasPicture) {
        syntax.option("--picture", options.picture, "Picture of the result", "F.svg|.pdf|.png");
    }
}

/// Settings of a file with those of the command line, which win.
Result<AnalysisTexts> mergedTexts(const AnalysisOptions& options, const std::string& specification) {
    if (specification.empty()) {
        return options.texts;
    }
    Result<AnalysisTexts> texts = readAnalysisSettings(*options.analysis, specification);
    if (!texts) {
        return texts;
    }
    for (const auto& [name, value] : options.texts.values) {
        if (!value.empty()) {
            texts->values[name] = value;
        }
    }
    for (const auto& [name, isGiven] : options.texts.flags) {
        texts->flags[name] = texts->flags[name] || isGiven;
    }
    return texts;
}

Result<AnalysisInput> inputOfSettings(CommandContext& context, const AnalysisOptions& options) {
    const Result<AnalysisTexts> texts = mergedTexts(options, options.input);
    if (!texts) {
        return failure(texts.error());
    }
    const Result<AnalysisValues> values = parseAnalysisValues(*options.analysis, texts->values, texts->flags);
    if (!values) {
        return failure(values.error());
    }
    return AnalysisInput{*values, {}, headerFor(context, std::string(options.analysis->schema))};
}

Result<AnalysisInput> inputOfRecording(CommandContext& context, const AnalysisOptions& options,
                                       const std::string& path) {
    const Result<AnalysisValues> values =
        parseAnalysisValues(*options.analysis, options.texts.values, options.texts.flags);
    const Result<void> fits =
        refuseGiven({{"--duration", !options.duration.empty()},
                     {"--rate", !options.rate.empty()},
                     {"--record", !options.recordFile.empty()}},
                    "belongs to a device, not to a recording", "leave it out, or name a device");
    if (!values || !fits) {
        return failure(values ? fits.error() : values.error());
    }
    Result<devices::RecordedFile> file =
        devices::readRecordingFile(path, [&context] { return checkInterrupt(context); });
    if (!file) {
        return failure(file.error());
    }
    sayWarnings(context, file->warnings);
    AnalysisInput input{*values, {}, headerFor(context, std::string(options.analysis->schema))};
    noteWarnings(input.header.quality, file->warnings);
    if (file->hasMeta) {
        input.header.device = file->meta.device;
        input.header.started = file->meta.started;
    }
    input.values.device = notedValues(*options.analysis, file->meta);
    input.file = *std::move(file);
    return input;
}

/// Records rows of a device, and keeps them with --record.
Result<devices::RecordedFile> recordRows(CommandContext& context, const AnalysisOptions& options,
                                         devices::Device& device, AnalysisInput& input) {
    const Result<std::optional<double>> duration = optionalNumber("--duration", options.duration);
    const Result<std::optional<double>> rate = optionalNumber("--rate", options.rate);
    if (!duration || !rate) {
        return failure(duration ? rate.error() : duration.error());
    }
    RecordConfig config;
    config.signals = deviceSignalsFor(*options.analysis, input.values, device.catalogue());
    config.duration_s = duration->value_or(StandardDuration_s);
    config.rate_Hz = rate->value_or(config.rate_Hz);
    const Result<RecordResult> rows = runRecord(device, config, observerFor(context));
    if (!rows) {
        return failure(rows.error());
    }
    addQuality(input.header.quality, rows->quality);
    if (!options.recordFile.empty()) {
        const auto written =
            writeRecording(options.recordFile, rows->recording, device, {input.header.started, {}, {}});
        if (!written) {
            return failure(written.error());
        }
        context.console.log(LogLevel::Info, "wrote " + options.recordFile);
    }
    devices::RecordedFile file;
    file.recording = rows->recording;
    return file;
}

Result<AnalysisInput> inputOfDevice(CommandContext& context, const AnalysisOptions& options) {
    const Analysis& analysis = *options.analysis;
    const Result<AnalysisValues> values =
        parseAnalysisValues(analysis, options.texts.values, options.texts.flags);
    if (!values) {
        return failure(values.error());
    }
    const Result<std::unique_ptr<devices::Device>> device = openDeviceFor(context, options.input);
    if (!device) {
        return failure(device.error());
    }
    const auto own = deviceValuesFor(analysis, **device);
    if (!own) {
        return failure(own.error());
    }
    AnalysisInput input{*values, {}, headerFor(context, std::string(analysis.schema), **device)};
    input.values.device = *own;
    if (analysis.recording == RecordingUse::Required) {
        Result<devices::RecordedFile> rows = recordRows(context, options, **device, input);
        if (!rows) {
            return failure(rows.error());
        }
        input.file = *std::move(rows);
    }
    return input;
}

Result<AnalysisInput> inputOf(CommandContext& context, const AnalysisOptions& options) {
    const std::optional<std::string> path = recordingPath(options.input);
    const bool isDevice = !path && !options.input.empty() && devices::parseDeviceUri(options.input);
    const bool isRequired = options.analysis->recording == RecordingUse::Required;
    if ((isRequired && !isDevice) || (path && options.analysis->recording == RecordingUse::Optional)) {
        return inputOfRecording(context, options, path.value_or(options.input));
    }
    return isDevice ? inputOfDevice(context, options) : inputOfSettings(context, options);
}

CommandOutputs outputsOf(const AnalysisOptions& options) {
    return {{options.out, options.picture}, {options.recordFile}};
}

/// The files that a file of settings names; those of the command line are checked with it.
Result<void> checkKeepsInputsOf(const AnalysisValues& values, const AnalysisOptions& options) {
    std::vector<std::string> named;
    for (const auto& [name, text] : values.texts) {
        named.push_back(text);
    }
    CommandOutputs outputs = outputsOf(options);
    outputs.inputs = namedInputs({}, std::move(named));
    return checkKeepsInputs(outputs);
}

CommandResult runAnalysisCommand(CommandContext& context, const AnalysisOptions& options) {
    const Analysis& analysis = *options.analysis;
    if (const Result<void> checked = checkPicture(options); !checked) {
        return failure(checked.error());
    }
    Result<AnalysisInput> input = inputOf(context, options);
    if (!input) {
        return failure(input.error());
    }
    if (const Result<void> kept = checkKeepsInputsOf(input->values, options); !kept) {
        return failure(kept.error());
    }
    ResultHeader& header = input->header;
    const std::optional<devices::RecordedFile>& file = input->file;
    const Result<AnalysisOutcome> result = analysis.run(input->values, file ? &*file : nullptr, options.input,
                                                        analysisControl(context, analysis));
    if (!result) {
        const Result<void> stopped = checkInterrupt(context);
        return failure(stopped ? result.error() : stopped.error());
    }
    addQuality(header.quality, result->quality);
    Result<void> written = writeOutput(context, options, *result);
    written = written ? writePicture(context, options, *result) : written;
    if (!written) {
        return failure(written.error());
    }
    if (!result->timing.empty()) {
        context.console.log(LogLevel::Info, result->timing);
    }
    JsonValue document = toJson(header);
    for (const JsonMember& member : result->body.members()) {
        document.set(member.key, member.value);
    }
    const std::string out = analysis.writesTable ? std::string() : options.out;
    if (const Result<void> done = deliver(context, document, result->summary, out); !done) {
        return failure(done.error());
    }
    return exitCodeFor(header.quality);
}

} // namespace

Command analysisCommand(const Analysis& analysis) {
    return makeCommand<AnalysisOptions>(std::string(analysis.name), std::string(analysis.help),
                                        {addOptions, runAnalysisCommand, outputsOf}, {&analysis});
}

} // namespace halbench::app
