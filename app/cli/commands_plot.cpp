#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/documents/result_header.h"
#include "app/documents/text/names.h"
#include "app/documents/text/numbers.h"
#include "app/documents/text/output_file.h"
#include "app/figures/recording_picture.h"
#include "app/headless/command_header.h"
#include "devices/formats/convert_recording.h"
#include "devices/formats/recording_file.h"

#include <fmt/format.h>

#include <filesystem>

namespace halbench::app {

namespace {

struct PlotOptions {
    std::string input, out;
    std::string signals, right; ///< names, separated by commas
    std::string from, to;
    std::string title;
    std::vector<std::string> derived;
};

/// The recording in the interval asked for, and what is known of it.
struct Source {
    Recording part;
    devices::RecordingMeta meta;
    bool hasMeta = false;
};

/// Measured values; states and counters only where somebody names them, or where there is nothing else.
std::vector<std::string> plottedNames(const StreamLayout& layout, const std::vector<std::string>& asked) {
    if (!asked.empty()) {
        return asked;
    }
    std::vector<std::string> names;
    for (const StreamLayout::Column& column : layout.columns) {
        if (!column.unit.empty()) {
            names.push_back(column.name);
        }
    }
    return names;
}

Result<Source> readSource(CommandContext& context, const PlotOptions& options) {
    const Result<std::optional<double>> from = optionalNumber("--from", options.from);
    const Result<std::optional<double>> to = optionalNumber("--to", options.to);
    const Result<std::vector<devices::DerivedSignal>> derived = derivedOption(options.derived);
    if (!from || !to || !derived) {
        return failure(!from ? from.error() : !to ? to.error() : derived.error());
    }
    Result<devices::RecordedFile> file =
        devices::readRecordingFile(options.input, [&context] { return checkInterrupt(context); });
    if (!file) {
        return failure(file.error());
    }
    for (const std::string& warning : file->warnings) {
        context.console.log(LogLevel::Warning, warning);
    }
    const Result<Recording> longer = devices::withDerived(std::move(file->recording), *derived);
    if (!longer) {
        return failure(longer.error());
    }
    const std::vector<std::string> names =
        plottedNames(*longer->layout, devices::withNamesOf(splitList(options.signals), *derived));
    Result<Recording> part = devices::selectPart(*longer, names, *from, *to);
    if (!part) {
        return failure(part.error());
    }
    return Source{*std::move(part), std::move(file->meta), file->hasMeta};
}

JsonValue namesOf(const StreamLayout& layout, const std::vector<std::size_t>& columns) {
    JsonValue names = JsonValue::array();
    for (const std::size_t column : columns) {
        names.push(layout.columns[column].name);
    }
    return names;
}

JsonValue toJson(const ResultHeader& header, const Source& source, const std::vector<PicturePanel>& places) {
    JsonValue document = toJson(header);
    document.set("rows", static_cast<std::uint64_t>(source.part.rows()));
    document.set("from_s", source.part.time_s.front()).set("to_s", source.part.time_s.back());
    JsonValue panels = JsonValue::array();
    const StreamLayout& layout = *source.part.layout;
    for (const PicturePanel& panel : places) {
        JsonValue one = JsonValue::object();
        one.set("unit", panel.unit).set("signals", namesOf(layout, panel.columns));
        if (!panel.rightColumns.empty()) {
            one.set("right", namesOf(layout, panel.rightColumns)).set("right_unit", panel.rightUnit);
        }
        panels.push(std::move(one));
    }
    return document.set("panels", std::move(panels));
}

CommandResult runPlotCommand(CommandContext& context, const PlotOptions& options) {
    if (!isPictureFile(options.out)) {
        return failure(ErrorCode::Usage,
                       fmt::format("'{}' is of no format of pictures that can be written", options.out),
                       "this version writes .svg, .pdf and .png");
    }
    const Result<Source> source = readSource(context, options);
    if (!source) {
        return failure(source.error());
    }
    const std::string name = std::filesystem::path(options.input).filename().string();
    const std::vector<std::string> right = splitList(options.right);
    const Result<std::vector<PicturePanel>> panels = picturePanels(*source->part.layout, right);
    const Result<std::string> picture =
        recordingPicture(source->part, options.title.empty() ? name : options.title, options.out, right);
    if (!panels || !picture) {
        return failure(panels ? picture.error() : panels.error());
    }
    if (const Result<void> written = writeFile(options.out, *picture); !written) {
        return failure(written.error());
    }
    context.console.log(LogLevel::Info, "wrote " + options.out);
    ResultHeader header = headerFor(context, "halbench.plot/1");
    if (source->hasMeta) {
        header.device = source->meta.device;
        header.started = source->meta.started;
    }
    if (const Result<void> printed = context.console.printDocument(toJson(header, *source, *panels));
        !printed) {
        return failure(printed.error());
    }
    return ExitCode::Done;
}

void addOptions(CommandSyntax& syntax, PlotOptions& options) {
    syntax.argument("RECORDING", options.input, "Recording");
    syntax.option("--out", options.out, "Picture", "FILE.svg|.pdf|.png", Presence::Required);
    syntax.option("--signals", options.signals, "Names, separated by commas", "A,B");
    syntax.option("--from", options.from, "First time", "S");
    syntax.option("--to", options.to, "Last time", "S");
    syntax.option("--right", options.right, "Those on the right axis of the panel of the signal before them",
                  "A,B");
    syntax.option("--title", options.title, "Instead of the file's name", "TITLE");
    addDerive(syntax, options.derived);
}

CommandOutputs outputsOf(const PlotOptions& options) {
    return {{options.out}, {}};
}

} // namespace

Command plotCommand() {
    return makeCommand<PlotOptions>("plot", "Draw a recording for print",
                                    {addOptions, runPlotCommand, outputsOf});
}

} // namespace halbench::app
