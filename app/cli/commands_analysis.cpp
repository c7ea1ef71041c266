#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/documents/text/output_file.h"
#include "app/headless/analysis_control.h"
#include "app/headless/command_header.h"
#include "app/headless/recording_integrity.h"

#include <fmt/format.h>

namespace halbench::app {

namespace {

struct AnalysisOptions {
    const Analysis* analysis;
    std::string input; ///< RECORDING
    std::string out;
    std::map<std::string, std::string> values; ///< by the keys of the analysis
    std::map<std::string, bool> flags;
};

Result<void> writeOutput(CommandContext& context, const AnalysisOptions& options,
                         const AnalysisOutcome& result) {
    if (options.out.empty() || !options.analysis->writesTable || !result.table) {
        return {};
    }
    const Result<void> free =
        options.input.empty() ? Result<void>() : checkIsNoInput(options.out, {options.input});
    const Result<void> written = free ? writeFile(options.out, analysisCsv(*result.table)) : free;
    if (written) {
        context.console.log(LogLevel::Info, "wrote " + options.out);
    }
    return written;
}

void addOptions(CommandSyntax& syntax, AnalysisOptions& options) {
    const Analysis& analysis = *options.analysis;
    if (analysis.needsRecording) {
        syntax.argument("RECORDING", options.input, "Recording");
    }
    for (const AnalysisKey& key : analysis.keys) {
        const std::string name(key.name);
        const std::string help(key.help);
        if (key.type == AnalysisKeyType::Flag) {
            syntax.flag(optionOf(key), options.flags[name], help);
        } else {
            syntax.option(optionOf(key), options.values[name], help,
                          key.choices.empty() ? "VALUE" : std::string(key.choices));
        }
    }
    syntax.option("--out", options.out, analysis.writesTable ? "Table" : "Result",
                  analysis.writesTable ? "FILE.csv" : "FILE.json");
}

CommandResult runAnalysisCommand(CommandContext& context, const AnalysisOptions& options) {
    const Analysis& analysis = *options.analysis;
    const Result<AnalysisValues> values = parseAnalysisValues(analysis, options.values, options.flags);
    if (!values) {
        return failure(values.error());
    }
    ResultHeader header = headerFor(context, std::string(analysis.schema));
    std::optional<devices::RecordedFile> file;
    if (analysis.needsRecording) {
        Result<devices::RecordedFile> read =
            devices::readRecordingFile(options.input, [&context] { return checkInterrupt(context); });
        if (!read) {
            return failure(read.error());
        }
        file = *std::move(read);
        sayWarnings(context, file->warnings);
        noteWarnings(header.quality, file->warnings);
        if (file->hasMeta) {
            header.device = file->meta.device;
            header.started = file->meta.started;
        }
    }
    const Result<AnalysisOutcome> result =
        analysis.run(*values, file ? &*file : nullptr, options.input, analysisControl(context, analysis));
    if (!result) {
        const Result<void> stopped = checkInterrupt(context);
        return failure(stopped ? result.error() : stopped.error());
    }
    addQuality(header.quality, result->quality);
    if (const Result<void> written = writeOutput(context, options, *result); !written) {
        return failure(written.error());
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

CommandOutputs outputsOf(const AnalysisOptions& options) {
    return {{options.out}, {}};
}

} // namespace

Command analysisCommand(const Analysis& analysis) {
    return makeCommand<AnalysisOptions>(std::string(analysis.name), std::string(analysis.help),
                                        {addOptions, runAnalysisCommand, outputsOf},
                                        {&analysis, {}, {}, {}, {}});
}

} // namespace halbench::app
