#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/cli/commands_retention.h"
#include "app/documents/result_history.h"
#include "app/documents/text/numbers.h"
#include "app/headless/command_header.h"
#include "app/recordings/recording_list.h"

#include <QtCore/QFileInfo>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace halbench::app {

namespace {

/// As `identify` calls them.
constexpr std::array<const char*, HistoryParameters.size()> Labels = {"viscous c", "Coulomb Kf", "torque phi",
                                                                      "inertia J"};

/// Newest first; those of one time, as all in virtual time, by name: files' dates play no part.
std::vector<RecordingEntry> recordingsFor(const RecordingsOptions& options, const QString& folder) {
    const QStringList words =
        QString::fromStdString(options.search).simplified().split(QLatin1Char(' '), Qt::SkipEmptyParts);
    std::vector<RecordingEntry> found;
    for (RecordingEntry& entry : recordingsIn(folder)) {
        if (hasWords(searchText(entry), words)) {
            found.push_back(std::move(entry));
        }
    }
    std::sort(found.begin(), found.end(), [](const RecordingEntry& one, const RecordingEntry& other) {
        return one.started != other.started ? one.started > other.started : one.path < other.path;
    });
    return found;
}

std::string fileOf(const RecordingEntry& entry) {
    return QFileInfo(entry.path).fileName().toStdString();
}

JsonValue toJson(const QStringList& words) {
    JsonValue list = JsonValue::array();
    for (const QString& word : words) {
        list.push(word.toStdString());
    }
    return list;
}

JsonValue toJson(const RecordingEntry& entry) {
    JsonValue document = JsonValue::object();
    document.set("file", fileOf(entry)).set("name", entry.name.toStdString());
    document.set("device", textOrNull(entry.device.toStdString())).set("simulated", entry.isSimulated);
    document.set("started", textOrNull(entry.started.toStdString()));
    document.set("duration_s", finiteOrNull(entry.duration_s)).set("signals", toJson(entry.signalNames));
    document.set("tags", toJson(entry.tags)).set("notes", textOrNull(entry.notes.toStdString()));
    document.set("results", toJson(entry.results)).set("gaps", entry.gaps);
    document.set("missing_rows", entry.missingRows).set("interrupted", entry.isInterrupted);
    return document;
}

JsonValue toJson(const control::Estimate& estimate, const std::optional<Drift>& drift) {
    JsonValue document = JsonValue::object();
    document.set("value", estimate.value).set("unit", estimate.unit);
    JsonValue interval;
    if (estimate.interval95) {
        interval = JsonValue::array();
        interval.push(estimate.interval95->first).push(estimate.interval95->second);
    }
    document.set("ci95", std::move(interval)).set("source", control::estimateSourceName(estimate.source));
    JsonValue change;
    if (drift) {
        change = JsonValue::object();
        change.set("ratio", drift->ratio).set("significant", drift->isSignificant);
    }
    return document.set("drift", std::move(change));
}

JsonValue toJson(const std::vector<ResultRow>& rows, std::size_t row) {
    const ResultHeader& header = rows[row].header;
    JsonValue document = JsonValue::object();
    document.set("file", rows[row].file)
        .set("device", header.device ? app::toJson(*header.device) : JsonValue());
    document.set("started", textOrNull(header.started)).set("verdict", verdictName(header.quality.verdict));
    JsonValue parameters = JsonValue::object();
    for (std::size_t i = 0; i < HistoryParameters.size(); ++i) {
        parameters.set(HistoryParameters[i], toJson(rows[row].values[i], driftAt(rows, row, i)));
    }
    return document.set("parameters", std::move(parameters));
}

JsonValue toJson(const ResultHeader& header, const std::vector<RecordingEntry>& recordings,
                 const std::vector<ResultRow>& results) {
    JsonValue document = toJson(header);
    JsonValue list = JsonValue::array();
    for (const RecordingEntry& entry : recordings) {
        list.push(toJson(entry));
    }
    JsonValue identifications = JsonValue::array();
    for (std::size_t row = 0; row < results.size(); ++row) {
        identifications.push(toJson(results, row));
    }
    document.set("recordings", std::move(list));
    return document.set("identifications", std::move(identifications));
}

std::string orDash(const std::string& text) {
    return text.empty() ? "-" : text;
}

std::string line(const RecordingEntry& entry) {
    std::string text =
        fmt::format("{:<32} {:<20} {:>9}  {}", fileOf(entry), orDash(entry.started.toStdString()),
                    entry.duration_s ? fmt::format("{:.6g} s", *entry.duration_s) : std::string("-"),
                    orDash(entry.device.toStdString()));
    text += entry.isInterrupted ? "  interrupted" : "";
    text += entry.gaps == 0 ? "" : fmt::format("  {} gaps ({} rows)", entry.gaps, entry.missingRows);
    text +=
        entry.tags.isEmpty() ? "" : fmt::format("  [{}]", entry.tags.join(QLatin1String(", ")).toStdString());
    text += entry.results.isEmpty() ? "" : "  " + entry.results.join(QLatin1String(", ")).toStdString();
    return text + '\n';
}

std::string driftText(const std::optional<Drift>& drift) {
    return drift ? fmt::format("  {:+.2f} % {}", 100.0 * drift->ratio,
                               drift->isSignificant ? "drifted" : "within the intervals")
                 : std::string();
}

std::string lines(const std::vector<ResultRow>& rows, std::size_t row) {
    const ResultHeader& header = rows[row].header;
    std::string text =
        fmt::format("{}  {}  {}  data {}\n", rows[row].file, orDash(header.started),
                    header.device ? orDash(header.device->id) : "-", verdictName(header.quality.verdict));
    for (std::size_t i = 0; i < HistoryParameters.size(); ++i) {
        std::string estimate = estimateLine(Labels[i], rows[row].values[i]);
        estimate.pop_back(); // the end of its line
        text += "  " + estimate + driftText(driftAt(rows, row, i)) + '\n';
    }
    return text;
}

std::string summaryText(const std::vector<RecordingEntry>& recordings,
                        const std::vector<ResultRow>& results) {
    std::string text = recordings.empty() ? "no recordings\n" : "";
    for (const RecordingEntry& entry : recordings) {
        text += line(entry);
    }
    text += results.empty() ? "" : "\nidentified values, against the first of the same device\n";
    for (std::size_t row = 0; row < results.size(); ++row) {
        text += lines(results, row);
    }
    return text;
}

CommandResult runRecordingsCommand(CommandContext& context, const RecordingsOptions& options) {
    if (!options.retain.empty() || options.isDeleted || options.isTrashed) {
        return runRetentionCommand(context, options);
    }
    const QString folder =
        options.input.empty() ? QStringLiteral(".") : QString::fromStdString(options.input);
    if (const QFileInfo info(folder); !info.isDir() || !info.isReadable()) {
        return failure(ErrorCode::FileSystem,
                       fmt::format("'{}' is no folder that can be read", options.input),
                       "give the folder of the recordings");
    }
    const std::vector<RecordingEntry> recordings = recordingsFor(options, folder);
    const std::vector<ResultRow> results = resultsIn(folder.toStdString());
    const JsonValue document = toJson(headerFor(context, "halbench.recordings/1"), recordings, results);
    if (const Result<void> done = deliver(context, document, summaryText(recordings, results), ""); !done) {
        return failure(done.error());
    }
    return ExitCode::Done;
}

void addOptions(CommandSyntax& syntax, RecordingsOptions& options) {
    syntax.option("FOLDER", options.input, "Default: the current one");
    syntax.option("--search", options.search, "Only those in which every word occurs", "WORDS");
    syntax.option("--retain", options.retain,
                  "What of the recordings that the program named is beyond N days or N GB; removes nothing",
                  "Nd,NGB");
    syntax.flag("--delete", options.isDeleted, "Delete what --retain finds, for good");
    syntax.flag("--trash", options.isTrashed, "Move what --retain finds to the trash");
}

} // namespace

Command recordingsCommand() {
    return makeCommand<RecordingsOptions>("recordings", "List a folder's recordings and identified values",
                                          {addOptions, runRecordingsCommand});
}

} // namespace halbench::app
