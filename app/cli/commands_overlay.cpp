#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/documents/result_header.h"
#include "app/documents/text/names.h"
#include "app/documents/text/numbers.h"
#include "app/headless/command_header.h"
#include "app/headless/recording_integrity.h"
#include "app/recordings/aligned_runs.h"
#include "devices/formats/convert_recording.h"
#include "devices/recording/recording_writer.h"

#include <QtCore/QFileInfo>

#include <fmt/format.h>

namespace halbench::app {

namespace {

struct OverlayOptions {
    std::vector<std::string> names; ///< of the recordings
    std::string signals;            ///< names, separated by commas
    std::string align;
    std::string from, to;
    std::string out;
};

std::string fileOf(const std::string& path) {
    return QFileInfo(QString::fromStdString(path)).fileName().toStdString();
}

/// One run with nothing but the signals asked for: many files may be large.
Result<ComparedRun> readRun(CommandContext& context, const std::string& path,
                            const std::vector<std::string>& signals) {
    Result<devices::RecordedFile> file =
        devices::readRecordingFile(path, [&context] { return checkInterrupt(context); });
    if (!file) {
        return failure(file.error());
    }
    sayWarnings(context, file->warnings);
    Result<Recording> part = devices::selectPart(file->recording, signals, {}, {});
    if (!part) {
        return failure(part.error().code, path + ": " + part.error().message, part.error().hint);
    }
    const std::string name = QFileInfo(QString::fromStdString(path)).completeBaseName().toStdString();
    return ComparedRun{name, *std::move(part), std::move(file->meta), {}, std::move(file->warnings)};
}

Result<std::vector<ComparedRun>> readRuns(CommandContext& context, const OverlayOptions& options) {
    const std::vector<std::string> signals = splitList(options.signals);
    if (options.names.size() < 2) {
        return failure(ErrorCode::Usage, "an overlay needs two recordings or more",
                       "name the files one after the other");
    }
    std::vector<ComparedRun> runs;
    for (const std::string& path : options.names) {
        Result<ComparedRun> run = readRun(context, path, signals);
        if (!run) {
            return failure(run.error());
        }
        runs.push_back(*std::move(run));
    }
    return runs;
}

Result<OverlayRequest> requestFrom(const OverlayOptions& options) {
    const Result<RunAlignment> alignment = alignmentNamed(options.align.empty() ? "start" : options.align);
    const Result<std::optional<double>> from = optionalNumber("--from", options.from);
    const Result<std::optional<double>> to = optionalNumber("--to", options.to);
    if (!alignment || !from || !to) {
        return failure(!alignment ? alignment.error() : !from ? from.error() : to.error());
    }
    return OverlayRequest{*alignment, *from, *to};
}

bool areOfOneDevice(const std::vector<ComparedRun>& runs) {
    for (const ComparedRun& run : runs) {
        if (!isSameDevice(run.meta.device, runs.front().meta.device)) {
            return false;
        }
    }
    return true;
}

/// The overlay is a recording itself: it opens, converts and is played as one.
devices::RecordingMeta metaOf(const std::vector<ComparedRun>& runs, const Recording& overlay,
                              const std::string& align) {
    devices::RecordingMeta meta;
    if (areOfOneDevice(runs)) {
        meta.device = runs.front().meta.device;
    }
    meta.started = runs.front().meta.started;
    meta.software = HALBENCH_VERSION;
    meta.period_s = overlay.layout->period_s;
    for (const StreamLayout::Column& column : overlay.layout->columns) {
        meta.signals.push_back(
            {column.name, devices::csvColumnName(column.name, column.unit), column.unit, ""});
    }
    if (overlay.time_s.front() <= 0.0 && overlay.time_s.back() >= 0.0) {
        meta.markers.push_back({0.0, "aligned at " + align});
    }
    return meta;
}

JsonValue differenceJson(const ColumnDifference& difference) {
    if (difference.rows == 0) {
        return {};
    }
    JsonValue document = JsonValue::object();
    document.set("rows", static_cast<std::uint64_t>(difference.rows)).set("mean", difference.mean);
    document.set("rms", difference.rms).set("largest", difference.largest);
    return document.set("largest_at_s", difference.largestAt_s);
}

/// The overlay with everything that is told of it.
struct Overlay {
    const OverlayOptions& options;
    const std::vector<ComparedRun>& runs;
    const OverlayRequest& request;
    Recording recording;

    std::size_t signals() const { return runs.front().recording.layout->columns.size(); }
    const StreamLayout::Column& column(std::size_t run, std::size_t signal) const {
        return recording.layout->columns[run * signals() + signal];
    }
    ColumnDifference difference(std::size_t run, std::size_t signal) const {
        return differenceBetween(recording, signal, run * signals() + signal);
    }
};

JsonValue runJson(const Overlay& overlay, std::size_t run) {
    const ComparedRun& compared = overlay.runs[run];
    const std::vector<std::string> columns = devices::csvColumnNames(*overlay.recording.layout);
    JsonValue signals = JsonValue::array();
    for (std::size_t signal = 0; signal < overlay.signals(); ++signal) {
        const StreamLayout::Column& column = overlay.column(run, signal);
        JsonValue entry = JsonValue::object();
        entry.set("name", compared.recording.layout->columns[signal].name).set("unit", column.unit);
        entry.set("column", columns[run * overlay.signals() + signal]);
        signals.push(entry.set("difference",
                               run == 0 ? JsonValue() : differenceJson(overlay.difference(run, signal))));
    }
    const devices::DeviceInfo& device = compared.meta.device;
    const bool isKnown = !device.model.empty() || !device.id.empty();
    JsonValue document = JsonValue::object();
    document.set("name", compared.name).set("file", fileOf(overlay.options.names[run]));
    document.set("device", isKnown ? toJson(device) : JsonValue());
    document.set("started", textOrNull(compared.meta.started));
    document.set("zero_s", finiteOrNull(alignedZero_s(compared, overlay.request.alignment)));
    return document.set("signals", std::move(signals));
}

JsonValue documentOf(const ResultHeader& header, const Overlay& overlay) {
    JsonValue document = toJson(header);
    const RunAlignment& alignment = overlay.request.alignment;
    const char* moment = alignment.moment == RunAlignment::Moment::Start     ? "start"
                         : alignment.moment == RunAlignment::Moment::Trigger ? "trigger"
                                                                             : "marker";
    JsonValue align = JsonValue::object();
    align.set("moment", moment).set("marker", textOrNull(alignment.marker));
    document.set("align", std::move(align)).set("period_s", overlay.recording.layout->period_s);
    document.set("rows", static_cast<std::uint64_t>(overlay.recording.rows()));
    document.set("from_s", overlay.recording.time_s.front()).set("to_s", overlay.recording.time_s.back());
    JsonValue runs = JsonValue::array();
    for (std::size_t run = 0; run < overlay.runs.size(); ++run) {
        runs.push(runJson(overlay, run));
    }
    return document.set("runs", std::move(runs));
}

std::string summaryText(const ResultHeader& header, const Overlay& overlay) {
    std::string text;
    for (std::size_t signal = 0; signal < overlay.signals(); ++signal) {
        const StreamLayout::Column& first = overlay.runs.front().recording.layout->columns[signal];
        text += fmt::format("{}{}, against {}\n", first.name, first.unit.empty() ? "" : " in " + first.unit,
                            overlay.runs.front().name);
        for (std::size_t run = 1; run < overlay.runs.size(); ++run) {
            const ColumnDifference difference = overlay.difference(run, signal);
            text += fmt::format("  {:<24} ", overlay.runs[run].name);
            text +=
                difference.rows == 0
                    ? std::string("no time in common\n")
                    : fmt::format("mean {:.6g}, rms {:.6g}, largest {:.6g} at {:.6g} s\n", difference.mean,
                                  difference.rms, difference.largest, difference.largestAt_s);
        }
    }
    return text + findingLines(header.quality);
}

/// A run that is not as it was recorded, or shares no time with the first one, cannot be compared with it.
DataQuality qualityOf(const Overlay& overlay) {
    DataQuality quality;
    for (const ComparedRun& run : overlay.runs) {
        noteWarnings(quality, run.warnings);
    }
    for (std::size_t run = 1; run < overlay.runs.size(); ++run) {
        for (std::size_t signal = 0; signal < overlay.signals(); ++signal) {
            if (overlay.difference(run, signal).rows == 0) {
                quality.verdict = Verdict::Doubtful;
                quality.findings.push_back(
                    {"no_common_time",
                     fmt::format("{} of '{}' has no time in common with '{}'", overlay.column(0, signal).name,
                                 overlay.runs[run].name, overlay.runs.front().name),
                     "align them at another moment, or give another --from and --to"});
            }
        }
    }
    return quality;
}

CommandResult runOverlayCommand(CommandContext& context, const OverlayOptions& options) {
    const Result<OverlayRequest> request = requestFrom(options);
    if (!request) {
        return failure(request.error());
    }
    const Result<std::vector<ComparedRun>> runs = readRuns(context, options);
    if (!runs) {
        return failure(runs.error());
    }
    Result<Recording> recording = onOneAxis(*runs, *request);
    if (!recording) {
        return failure(recording.error());
    }
    const Overlay overlay{options, *runs, *request, *std::move(recording)};
    const std::string align = options.align.empty() ? "start" : options.align;
    if (const Result<void> written = devices::writeExactRecordingFile(
            options.out, overlay.recording, metaOf(*runs, overlay.recording, align));
        !written) {
        return failure(written.error());
    }
    context.console.log(LogLevel::Info,
                        fmt::format("wrote {} ({} rows)", options.out, overlay.recording.rows()));
    ResultHeader header = headerFor(context, "halbench.overlay/1");
    header.quality = qualityOf(overlay);
    if (const Result<void> done =
            deliver(context, documentOf(header, overlay), summaryText(header, overlay), "");
        !done) {
        return failure(done.error());
    }
    return ExitCode::Done;
}

void addOptions(CommandSyntax& syntax, OverlayOptions& options) {
    syntax.arguments("RECORDING", options.names, "Two or more; the others are compared with the first");
    syntax.option("--signals", options.signals, "Names, separated by commas", "A,B", Presence::Required);
    syntax.option("--align", options.align, "start (default), trigger or marker:TEXT");
    syntax.option("--from", options.from, "First time, since that moment", "S");
    syntax.option("--to", options.to, "Last time, since that moment", "S");
    syntax.recording("--out", options.out, "Recording of all of them", Presence::Required);
}

CommandOutputs outputsOf(const OverlayOptions& options) {
    return {{}, {options.out}};
}

} // namespace

Command overlayCommand() {
    return makeCommand<OverlayOptions>("overlay", "Lay recordings over each other on one time axis",
                                       {addOptions, runOverlayCommand, outputsOf});
}

} // namespace halbench::app
