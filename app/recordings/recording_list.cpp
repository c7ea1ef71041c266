#include "app/recordings/recording_list.h"

#include "app/recordings/sidecar_change.h"
#include "devices/formats/convert_recording.h"
#include "devices/formats/recording_file.h"
#include "devices/recording/file_access.h"
#include "devices/recording/recording_meta.h"
#include "devices/recording/recording_writer.h"

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>
#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>

#include <fmt/format.h>
#include <sys/file.h>

#include <algorithm>

namespace halbench::app {

namespace {

constexpr const char* PartialEnding = ".csv.partial";

QString sidecarOf(const RecordingEntry& entry) {
    const QString data = entry.isInterrupted ? entry.path.chopped(8) : entry.path; // ".partial"
    const QString meta = QString::fromStdString(devices::metaPathOf(data.toStdString()));
    return entry.isInterrupted ? meta + QLatin1String(".partial") : meta;
}

QStringList listOf(const std::vector<std::string>& words) {
    QStringList list;
    for (const std::string& word : words) {
        list.append(QString::fromStdString(word));
    }
    return list;
}

void takeMeta(const devices::RecordingMeta& meta, RecordingEntry& entry) {
    entry.device = QString::fromStdString(meta.device.id.empty() ? meta.device.model : meta.device.id);
    entry.isSimulated = meta.device.isSimulated;
    entry.started = QString::fromStdString(meta.started);
    entry.date = QDateTime::fromString(entry.started, Qt::ISODate);
    entry.gaps = meta.gaps.size();
    for (const auto& gap : meta.gaps) {
        entry.missingRows += gap.lostRows;
    }
    if (meta.rows > 0 && meta.period_s > 0.0) {
        entry.duration_s = static_cast<double>(meta.rows + entry.missingRows) * meta.period_s;
    }
    for (const auto& note : meta.signals) {
        entry.signalNames.append(QString::fromStdString(note.name));
    }
    entry.tags = listOf(meta.tags);
    entry.notes = QString::fromStdString(meta.notes);
    entry.hasOwnName = entry.name.isEmpty() || entry.name.toStdString() != meta.automaticName;
}

void readSidecar(RecordingEntry& entry) {
    QFile file(sidecarOf(entry));
    if (!file.open(QIODevice::ReadOnly)) {
        return;
    }
    const Result<devices::RecordingMeta> meta =
        devices::parseMetaJson(file.readAll().toStdString(), file.fileName().toStdString());
    entry.hasSidecar = meta.has_value() && !entry.isInterrupted;
    if (meta) {
        takeMeta(*meta, entry);
    }
}

/// A writer holds its lock as long as it lives.
bool isBeingWritten(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return false;
    }
    const bool isFree = ::flock(file.handle(), LOCK_SH | LOCK_NB) == 0;
    return !isFree;
}

QStringList documentsIn(const QDir& folder) {
    return folder.entryList({QStringLiteral("*.json")}, QDir::Files);
}

/// "run.model.json" and "run.json" belong to "run.csv"; no sidecar does.
QStringList resultsOf(const QString& name, const QStringList& documents) {
    QStringList results;
    for (const QString& document : documents) {
        const bool isIts =
            document == name + QLatin1String(".json") ||
            (document.startsWith(name + QLatin1Char('.')) && !document.endsWith(QLatin1String(".meta.json")));
        if (isIts) {
            results.append(document);
        }
    }
    return results;
}

std::optional<RecordingEntry> entryOf(const QFileInfo& file, const QStringList& documents) {
    RecordingEntry entry;
    entry.path = file.filePath();
    entry.isInterrupted = entry.path.endsWith(QLatin1String(PartialEnding));
    if (entry.isInterrupted && (file.size() == 0 || isBeingWritten(entry.path))) {
        return std::nullopt;
    }
    entry.name = entry.isInterrupted ? file.fileName().chopped(12) : file.completeBaseName();
    readSidecar(entry);
    if (!entry.date.isValid() || entry.date.toSecsSinceEpoch() == 0) { // virtual time begins in 1970
        entry.date = file.lastModified().toUTC();
    }
    entry.results = resultsOf(entry.name, documents);
    return entry;
}

} // namespace

std::optional<RecordingEntry> recordingAt(const QString& path) {
    const QFileInfo file(path);
    return file.isFile() ? entryOf(file, documentsIn(file.dir())) : std::nullopt;
}

std::vector<RecordingEntry> recordingsIn(const QString& folder) {
    std::vector<RecordingEntry> entries;
    const QDir dir(folder);
    const QStringList documents = documentsIn(dir);
    const QFileInfoList files = dir.entryInfoList(
        {QStringLiteral("*.csv"), QStringLiteral("*.mf4"), QStringLiteral("*.csv.partial")}, QDir::Files);
    for (const QFileInfo& file : files) {
        if (std::optional<RecordingEntry> entry = entryOf(file, documents)) {
            entries.push_back(*std::move(entry));
        }
    }
    std::stable_sort(entries.begin(), entries.end(),
                     [](const auto& one, const auto& other) { return one.date > other.date; });
    return entries;
}

QString searchText(const RecordingEntry& entry) {
    const QStringList words = {entry.name,
                               entry.device,
                               entry.date.toString(Qt::ISODate),
                               entry.signalNames.join(QLatin1Char(' ')),
                               entry.tags.join(QLatin1Char(' ')),
                               entry.notes,
                               entry.results.join(QLatin1Char(' '))};
    return words.join(QLatin1Char('\n'));
}

bool hasWords(const QString& text, const QStringList& words) {
    return std::all_of(words.begin(), words.end(),
                       [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

QStringList tagsOf(const QString& text) {
    QStringList tags;
    for (const QString& word : text.split(QLatin1Char(','))) {
        const QString tag = word.simplified();
        if (!tag.isEmpty() && !tags.contains(tag)) {
            tags.append(tag);
        }
    }
    return tags;
}

Result<void> writeRecordingNotes(const QString& path, const QStringList& tags, const QString& notes) {
    return changeSidecar(path, "tags and notes need a recording with a .meta.json file",
                         [&](QJsonObject& root) {
                             root.remove(QStringLiteral("tags"));
                             root.remove(QStringLiteral("notes"));
                             if (!tags.isEmpty()) {
                                 root.insert(QStringLiteral("tags"), QJsonArray::fromStringList(tags));
                             }
                             if (!notes.isEmpty()) {
                                 root.insert(QStringLiteral("notes"), notes);
                             }
                         });
}

Result<RecoveredRecording> recoverRecording(const QString& path) {
    const QString own = path.chopped(8); // ".partial"
    QString target = own;
    for (int number = 2; QFileInfo::exists(target); ++number) {
        target = QStringLiteral("%1-%2.csv").arg(own.chopped(4)).arg(number);
    }
    const Result<devices::Conversion> done =
        devices::convertRecording({path.toStdString(), target.toStdString(), {}, {}, {}});
    if (!done) {
        return failure(done.error());
    }
    const devices::Recovery recovery = done->recovery.value_or(devices::Recovery());
    const std::string kept = devices::retirePartialRecording(path.toStdString(), recovery.damagedOctets > 0);
    return RecoveredRecording{target, recovery.rows, recovery.duration_s,
                              recovery.cutOctets + recovery.damagedOctets, QString::fromStdString(kept)};
}

} // namespace halbench::app
