#include "app/recordings/recording_retention.h"

#include "app/documents/text/names.h"
#include "devices/recording/file_access.h"
#include "devices/recording/recording_meta.h"

#include <QtCore/QCryptographicHash>
#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace halbench::app {

namespace {

constexpr qint64 Recent_s = 86400;
constexpr qint64 Day_s = 86400;
constexpr qint64 Future_s =
    300; ///< by so much the clocks of a disk in the network and of this machine differ
constexpr const char* Example = "use e.g. --retain 30d, --retain 20GB or --retain 30d,20GB";

QString sidecarPath(const QString& data) {
    return QString::fromStdString(devices::metaPathOf(data.toStdString()));
}

/// Of "30d" and "d" the 30; nothing when it ends otherwise or is no whole number from 1 on.
std::optional<std::uint64_t> countBefore(const std::string& text, const std::string& unit) {
    if (text.size() <= unit.size() || text.compare(text.size() - unit.size(), unit.size(), unit) != 0) {
        return std::nullopt;
    }
    std::uint64_t count = 0;
    const char* const end = text.data() + text.size() - unit.size();
    const auto parsed = std::from_chars(text.data(), end, count);
    return parsed.ec == std::errc{} && parsed.ptr == end && count > 0 ? std::optional(count) : std::nullopt;
}

/// Only a complete CSV recording has a sidecar that can say who named it.
std::optional<NamedRecording> namedBy(const RecordingEntry& entry) {
    if (!entry.hasSidecar || entry.hasOwnName || !entry.path.endsWith(QLatin1String(".csv"))) {
        return std::nullopt;
    }
    const QFileInfo data(entry.path);
    const QFileInfo sidecar(sidecarPath(entry.path));
    const QDateTime touched = std::max(data.lastModified(), sidecar.lastModified()).toUTC();
    return NamedRecording{entry.path, entry.name, std::max(entry.date, touched),
                          static_cast<std::uint64_t>(data.size() + sidecar.size())};
}

/// A picture, a model, a layout: whatever bears the recording's name is a reason to keep it.
bool hasCompanion(const QStringList& files, const QString& name) {
    return std::any_of(files.begin(), files.end(), [&](const QString& file) {
        return file.startsWith(name + QLatin1Char('.')) && file != name + QLatin1String(".csv") &&
               file != name + QLatin1String(".meta.json");
    });
}

/// Root may write what its owner protected; that is meant all the same.
bool isWritable(const QFileInfo& file) {
    return file.isWritable() && file.permission(QFileDevice::WriteOwner);
}

QStringList filesIn(const QString& folder) {
    return QDir(folder).entryList(QDir::AllEntries | QDir::Hidden, QDir::Unsorted);
}

/// `files` are those of its folder.
std::optional<KeptBecause> protectionOf(const RecordingEntry& entry, const NamedRecording& recording,
                                        const QStringList& files, const QDateTime& now) {
    const QFileInfo data(recording.path);
    const QFileInfo sidecar(sidecarPath(recording.path));
    if (data.isSymLink() || sidecar.isSymLink()) {
        return KeptBecause::Link;
    }
    if (!entry.tags.isEmpty()) {
        return KeptBecause::Tags;
    }
    if (!entry.notes.isEmpty()) {
        return KeptBecause::Notes;
    }
    if (!entry.results.isEmpty() || hasCompanion(files, recording.name)) {
        return KeptBecause::Results;
    }
    if (!isWritable(data) || !isWritable(sidecar)) {
        return KeptBecause::WriteProtected;
    }
    if (recording.date.secsTo(now) < Recent_s) { // also what lies in the future: a clock is wrong
        return KeptBecause::Recent;
    }
    return devices::isHeld(recording.path.toStdString()) ? std::optional(KeptBecause::Open) : std::nullopt;
}

/// Whether the rows are those that were recorded.
bool isUnchanged(const QString& path) {
    QFile data(path);
    QFile sidecar(sidecarPath(path));
    if (!data.open(QIODevice::ReadOnly) || !sidecar.open(QIODevice::ReadOnly)) {
        return false;
    }
    const auto meta =
        devices::parseMetaJson(sidecar.readAll().toStdString(), sidecar.fileName().toStdString());
    QCryptographicHash hash(QCryptographicHash::Sha256);
    return meta && hash.addData(&data) && hash.result().toHex().toStdString() == meta->sha256;
}

Result<void> removeFile(const QString& path, RemovalWay way, const TrashMove& moveToTrash) {
    QFile file(path);
    if (way == RemovalWay::Trash ? moveToTrash(path) : file.remove()) {
        return {};
    }
    if (way == RemovalWay::Trash) {
        return failure(ErrorCode::FileSystem,
                       fmt::format("'{}' cannot be moved to the trash", path.toStdString()),
                       "empty the trash; on a disk without trash use `halbench recordings --retain ... "
                       "--delete` to delete permanently");
    }
    return failure(ErrorCode::FileSystem,
                   fmt::format("cannot remove '{}': {}", path.toStdString(), devices::causeOf(file)),
                   "check that the folder can be written");
}

} // namespace

Result<RetentionLimits> parseRetention(const std::string& text) {
    RetentionLimits limits;
    for (const std::string& part : splitList(text)) {
        const auto days = countBefore(part, "d");
        const auto size_GB = countBefore(part, "GB");
        const bool isTwice = (days && limits.days) || (size_GB && limits.size_bytes);
        const bool isLimit =
            (days && *days <= MostRetentionDays) || (size_GB && *size_GB <= MostRetention_GB);
        if (isTwice || !isLimit) {
            return failure(ErrorCode::Usage, fmt::format("invalid limit '{}' for --retain", part), Example);
        }
        if (days) {
            limits.days = static_cast<int>(*days);
        } else {
            limits.size_bytes = *size_GB * RetentionGB_bytes;
        }
    }
    return limits.isOn() ? Result<RetentionLimits>(limits)
                         : failure(ErrorCode::Usage, "--retain needs a limit", Example);
}

std::string keptBecauseText(KeptBecause reason) {
    switch (reason) {
    case KeptBecause::Tags:
        return "it has tags";
    case KeptBecause::Notes:
        return "it has notes";
    case KeptBecause::Results:
        return "another file has the same name";
    case KeptBecause::Open:
        return "it is open";
    case KeptBecause::Recent:
        return "it is less than 24 hours old";
    case KeptBecause::WriteProtected:
        return "it is write-protected";
    case KeptBecause::Link:
        return "it is a link";
    case KeptBecause::ClockInDoubt:
        return "the date is uncertain (check the clock)";
    case KeptBecause::Changed:
        break;
    }
    return "its data were changed";
}

RetentionPlan planRetention(const QString& folder, const RetentionLimits& limits, const QDateTime& now) {
    struct Candidate {
        RecordingEntry entry;
        NamedRecording recording;
    };
    RetentionPlan plan;
    std::vector<Candidate> candidates;
    for (RecordingEntry& entry : recordingsIn(folder)) {
        if (auto recording = namedBy(entry)) {
            plan.before_bytes += recording->size_bytes;
            candidates.push_back({std::move(entry), *std::move(recording)});
        }
    }
    plan.recordings = candidates.size();
    std::sort(candidates.begin(), candidates.end(), [](const Candidate& one, const Candidate& other) {
        return std::pair(one.recording.date, one.recording.path) <
               std::pair(other.recording.date, other.recording.path);
    });
    plan.after_bytes = plan.before_bytes;
    if (!candidates.empty() && now.secsTo(candidates.back().recording.date) > Future_s) {
        plan.fromFuture = candidates.back().recording.name;
    }
    const QStringList files = filesIn(folder); // once: there may be thousands
    for (const Candidate& each : candidates) {
        const bool isTooOld = limits.days && each.recording.date.secsTo(now) > *limits.days * Day_s;
        const bool isTooMuch = limits.size_bytes && plan.after_bytes > *limits.size_bytes;
        if (!isTooOld && !isTooMuch) {
            continue;
        }
        if (const auto reason = protectionOf(each.entry, each.recording, files, now)) {
            plan.kept.push_back({each.recording, *reason});
        } else if (!plan.fromFuture.isEmpty()) {
            plan.kept.push_back({each.recording, KeptBecause::ClockInDoubt});
        } else {
            plan.removals.push_back({each.recording, isTooOld});
            plan.after_bytes -= each.recording.size_bytes;
        }
    }
    return plan;
}

bool systemTrash(const QString& path) {
    return QFile::moveToTrash(path);
}

Result<void> removeRecording(const RetentionPlan::Removal& removal, RemovalWay way, const QDateTime& now,
                             const TrashMove& moveToTrash) {
    const QString& path = removal.recording.path;
    // The rows first, which take minutes: somebody may open the recording meanwhile, or write a note.
    const bool isSame = isUnchanged(path);
    const std::optional<RecordingEntry> entry = recordingAt(path);
    const auto recording = entry ? namedBy(*entry) : std::nullopt;
    const auto kept = isSame && recording
                          ? protectionOf(*entry, *recording, filesIn(QFileInfo(path).path()), now)
                          : std::optional(KeptBecause::Changed);
    if (kept) {
        return failure(
            ErrorCode::Refused,
            fmt::format("'{}' is kept: {}", removal.recording.name.toStdString(), keptBecauseText(*kept)),
            "it is checked again next time");
    }
    const Result<void> removed = removeFile(path, way, moveToTrash);
    return removed ? removeFile(sidecarPath(path), way, moveToTrash) : removed;
}

} // namespace halbench::app
