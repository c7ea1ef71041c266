#pragma once

#include "control/base/result.h"

#include <QtCore/QDateTime>
#include <QtCore/QString>
#include <QtCore/QStringList>

#include <cstdint>
#include <optional>
#include <vector>

namespace halbench::app {

/// One recording of a folder as its sidecar tells it; its rows are not read.
struct RecordingEntry {
    QString path;   ///< of the data: .csv, .mf4, or .csv.partial of an interrupted one
    QString name;   ///< without folder and ending
    QString device; ///< serial number, else model
    bool isSimulated = false;
    QString started; ///< ISO 8601, UTC, as the sidecar says it; virtual time begins in 1970
    QDateTime date;  ///< when it began; without a time on the wall: when the file was written
    std::optional<double> duration_s;
    QStringList signalNames;
    QStringList tags;
    QString notes;
    QStringList results; ///< JSON documents beside it that bear its name
    std::uint64_t gaps = 0;
    std::uint64_t missingRows = 0;
    bool isInterrupted = false; ///< it can be recovered
    bool hasSidecar = false;    ///< otherwise it has neither tags nor notes
    bool hasOwnName = true;     ///< somebody's, or not known to be the program's

    bool operator==(const RecordingEntry&) const = default;
};

/// All recordings of a folder, the newest first; none when there is no such folder. A recording that is still
/// being written is left out. For a thread of its own: a folder may be large, or far away.
std::vector<RecordingEntry> recordingsIn(const QString& folder);

/// One of them, as it is now; nothing when it is gone or being written.
std::optional<RecordingEntry> recordingAt(const QString& path);

/// What a recording is searched by: name, device, date, signals, tags, notes, results.
QString searchText(const RecordingEntry& entry);
/// Whether every word occurs in it; upper and lower case are the same.
bool hasWords(const QString& text, const QStringList& words);

/// Words of the user for one recording, into its sidecar; everything else in it stays as it is.
/// Errors: FileSystem, InvalidInput (the sidecar is damaged).
Result<void> writeRecordingNotes(const QString& path, const QStringList& tags, const QString& notes);

/// "cold, new bearing" as a list, without empty ones and each only once.
QStringList tagsOf(const QString& text);

/// What was saved of an interrupted recording.
struct RecoveredRecording {
    QString path;
    std::size_t rows = 0;
    double duration_s = 0.0;
    std::uint64_t lostOctets = 0; ///< cut off or damaged
    QString keptOriginal;         ///< the interrupted file where it was damaged; else empty
};
/// Makes a recording of `run.csv.partial`, under that name or, when it is taken, one beside it. A damaged one
/// is called `run.csv.damaged` from then on: it is recovered once.
/// Errors: as of devices::convertRecording().
Result<RecoveredRecording> recoverRecording(const QString& path);

} // namespace halbench::app
