#include "app/cli/commands_retention.h"

#include "app/cli/command_support.h"
#include "app/documents/result_header.h"
#include "app/headless/command_header.h"
#include "app/recordings/recording_retention.h"

#include <QtCore/QFileInfo>

#include <fmt/format.h>

namespace halbench::app {

namespace {

/// A recording of the plan and what became of it.
struct Outcome {
    const RetentionPlan::Removal* removal = nullptr;
    std::string action = "none"; ///< none, trash, delete, kept
    std::string why;             ///< kept: by what
};

struct Outcomes {
    std::vector<Outcome> list;
    std::uint64_t after_bytes = 0;
    std::optional<Error> error; ///< the first that is no protection
};

Result<RetentionLimits> limitsFrom(const RecordingsOptions& options) {
    if (options.retain.empty()) {
        return failure(ErrorCode::Usage, "--delete and --trash belong to --retain",
                       "say what is kept, e.g. --retain 30d");
    }
    if (!options.search.empty()) {
        return failure(ErrorCode::Usage, "--search does not go with --retain",
                       "tag what shall stay; a recording with tags is never removed");
    }
    if (options.isDeleted && options.isTrashed) {
        return failure(ErrorCode::Usage, "--delete and --trash exclude each other", "give one of them");
    }
    return parseRetention(options.retain);
}

Outcomes carryOut(CommandContext& context, const RetentionPlan& plan, const RecordingsOptions& options,
                  const QDateTime& now) {
    const bool isDone = options.isDeleted || options.isTrashed;
    Outcomes outcomes{{}, isDone ? plan.before_bytes : plan.after_bytes, {}};
    for (const RetentionPlan::Removal& removal : plan.removals) {
        Outcome outcome{&removal, "none", {}};
        if (isDone && !outcomes.error) {
            const RemovalWay way = options.isTrashed ? RemovalWay::Trash : RemovalWay::Delete;
            const Result<void> goOn = checkInterrupt(context);
            const Result<void> removed = goOn ? removeRecording(removal, way, now) : goOn;
            if (removed) {
                outcome.action = options.isTrashed ? "trash" : "delete";
                outcomes.after_bytes -= removal.recording.size_bytes;
                context.console.log(LogLevel::Info,
                                    fmt::format("{} {}",
                                                options.isTrashed ? "moved to the trash:" : "deleted",
                                                removal.recording.path.toStdString()));
            } else if (removed.error().code == ErrorCode::Refused) {
                outcome.action = "kept";
                outcome.why = removed.error().message;
            } else {
                outcomes.error = removed.error();
            }
        }
        outcomes.list.push_back(std::move(outcome));
    }
    return outcomes;
}

std::string fileOf(const NamedRecording& recording) {
    return QFileInfo(recording.path).fileName().toStdString();
}

JsonValue toJson(const NamedRecording& recording) {
    JsonValue document = JsonValue::object();
    return document.set("file", fileOf(recording))
        .set("date", recording.date.toString(Qt::ISODate).toStdString())
        .set("bytes", recording.size_bytes);
}

JsonValue documentOf(const ResultHeader& header, const RetentionLimits& limits, const RetentionPlan& plan,
                     const Outcomes& outcomes) {
    JsonValue removals = JsonValue::array();
    for (const Outcome& outcome : outcomes.list) {
        JsonValue item = toJson(outcome.removal->recording);
        item.set("reason", outcome.removal->isTooOld ? "days" : "size").set("action", outcome.action);
        removals.push(item.set("kept_because", textOrNull(outcome.why)));
    }
    JsonValue kept = JsonValue::array();
    for (const RetentionPlan::Kept& each : plan.kept) {
        kept.push(toJson(each.recording).set("kept_because", keptBecauseText(each.reason)));
    }
    JsonValue document = toJson(header);
    document.set("days", limits.days).set("limit_bytes", limits.size_bytes);
    document.set("recordings", static_cast<std::uint64_t>(plan.recordings));
    document.set("before_bytes", plan.before_bytes).set("after_bytes", outcomes.after_bytes);
    document.set("dated_after_now", textOrNull(plan.fromFuture.toStdString()));
    return document.set("removals", std::move(removals)).set("kept", std::move(kept));
}

std::string sizeText(std::uint64_t bytes) {
    return fmt::format("{:.3g} GB", static_cast<double>(bytes) / static_cast<double>(RetentionGB_bytes));
}

std::string wordFor(const Outcome& outcome) {
    if (outcome.action == "none") {
        return "would go";
    }
    return outcome.action == "trash" ? "to the trash" : outcome.action == "delete" ? "deleted" : "stays";
}

std::string lineOf(const Outcome& outcome, const RetentionLimits& limits) {
    const NamedRecording& recording = outcome.removal->recording;
    const std::string reason = !outcome.why.empty() ? outcome.why
                               : outcome.removal->isTooOld
                                   ? fmt::format("more than {} days old", limits.days.value_or(0))
                                   : "no room for it in " + sizeText(limits.size_bytes.value_or(0));
    return fmt::format("{:<13} {:<40} {:<20} {:>9}  {}\n", wordFor(outcome), fileOf(recording),
                       recording.date.toString(Qt::ISODate).toStdString(), sizeText(recording.size_bytes),
                       reason);
}

std::string textOf(const RetentionLimits& limits, const RetentionPlan& plan, const Outcomes& outcomes,
                   bool isDryRun) {
    std::string text;
    for (const Outcome& outcome : outcomes.list) {
        text += lineOf(outcome, limits);
    }
    for (const RetentionPlan::Kept& each : plan.kept) {
        text += fmt::format("{:<13} {:<40} {:<20} {:>9}  {}\n", "stays", fileOf(each.recording),
                            each.recording.date.toString(Qt::ISODate).toStdString(),
                            sizeText(each.recording.size_bytes), keptBecauseText(each.reason));
    }
    text += fmt::format("{} recordings that the program named: {}, {} {}\n", plan.recordings,
                        sizeText(plan.before_bytes), isDryRun ? "would become" : "now",
                        sizeText(outcomes.after_bytes));
    if (!plan.fromFuture.isEmpty()) {
        text +=
            fmt::format("nothing goes: '{}' is dated after now, so the clock is or was wrong; set it right, "
                        "or rename that recording: what has a name of its own is not counted\n",
                        plan.fromFuture.toStdString());
    }
    if (limits.size_bytes && outcomes.after_bytes > *limits.size_bytes) {
        text += fmt::format("that is more than {}: what stays is protected\n", sizeText(*limits.size_bytes));
    }
    if (isDryRun && !outcomes.list.empty()) {
        text += "nothing was removed; --trash moves it to the trash, --delete deletes it for good\n";
    }
    return text;
}

} // namespace

CommandResult runRetentionCommand(CommandContext& context, const RecordingsOptions& options) {
    const Result<RetentionLimits> limits = limitsFrom(options);
    if (!limits) {
        return failure(limits.error());
    }
    const QString folder =
        options.input.empty() ? QStringLiteral(".") : QString::fromStdString(options.input);
    if (const QFileInfo info(folder); !info.isDir() || !info.isReadable()) {
        return failure(ErrorCode::FileSystem,
                       fmt::format("'{}' is no folder that can be read", options.input),
                       "give the folder of the recordings");
    }
    const QDateTime now = QDateTime::fromString(QString::fromStdString(context.wallClock()), Qt::ISODate);
    const RetentionPlan plan = planRetention(folder, *limits, now);
    const Outcomes outcomes = carryOut(context, plan, options, now);
    const bool isDryRun = !options.isDeleted && !options.isTrashed;
    const JsonValue document =
        documentOf(headerFor(context, "halbench.retention/1"), *limits, plan, outcomes);
    if (outcomes.error) {
        return failure(*outcomes.error);
    }
    const Result<void> done = deliver(context, document, textOf(*limits, plan, outcomes, isDryRun), "");
    return done ? CommandResult(ExitCode::Done) : failure(done.error());
}

} // namespace halbench::app
