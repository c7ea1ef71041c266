#pragma once

#include "control/base/sample_block.h"
#include "devices/recording/background_flush.h"
#include "devices/recording/disk_access.h"
#include "devices/recording/recording_csv.h"
#include "devices/recording/recording_meta.h"

#include <QtCore/QCryptographicHash>
#include <QtCore/QFile>

#include <memory>
#include <optional>
#include <string>

namespace halbench::devices {

/// Working name of a file until it is complete: "dir/run.csv" -> "dir/run.csv.partial".
std::string partialPathOf(const std::string& path);
/// The checksums of that file: "dir/run.csv" -> "dir/run.chunks.partial".
std::string journalPathOf(const std::string& path);
/// The whole sidecar until the data beside it have their name: "dir/run.meta.json.partial.new".
std::string completeMetaPathOf(const std::string& path);
/// A sidecar for a recovery until it has replaced the one before: "dir/run.meta.json.partial.next".
std::string nextMetaPathOf(const std::string& path);

/// What a power loss may take of a recording that goes on.
constexpr double FlushInterval_s = 1.0;

struct WriterOptions {
    std::string suffix = ".partial";       ///< of the working name
    std::optional<double> flushInterval_s; ///< to the disk in the background; else at the end only
    DiskAccess disk = realDisk();
    /// A replayed recording is written exactly whatever this says: its numbers were read, not measured.
    CsvNumbers numbers = CsvNumbers::BoardFloats;
};

/// What happened while rows came; times on the recording's axis.
struct RecordingEvents {
    std::vector<RecordingMeta::Marker> markers;
    std::vector<RecordingMeta::ParameterChange> changes;
    std::uint64_t droppedRows = 0;
    std::vector<RateChange> rates = {};
};

/// Writes a recording as it comes, as `path.partial`; every block is with the system when append() returns,
/// so that a killed program loses none of them. finish() gives it its name and its sidecar. A recording that
/// ended otherwise stays as `path.partial` for readPartialRecording(). Never drops a row silently: the first
/// error stays and finish() repeats it. Thread: one.
class RecordingWriter {
public:
    /// Folders are created. What an interrupted program left under the working name is moved aside, never
    /// lost. Errors: FileSystem with path and cause; Usage when another program is writing it now.
    static Result<std::unique_ptr<RecordingWriter>> create(const std::string& path,
                                                           const StreamLayout& layout, RecordingMeta meta,
                                                           WriterOptions options = {});

    Result<void> append(const SampleBlock& block);
    /// For the sidecar; times on the recording's axis.
    void addMarker(double time_s, const std::string& text);
    void addChange(double time_s, const std::string& parameter, double value);
    /// For a recovery, while the recording goes on: its sidecar with these beside what was added. The one
    /// before stays until this one is whole. Errors: FileSystem; the recording itself goes on.
    Result<void> keepEvents(const RecordingEvents& events);
    /// Rows that never came here because the disk did not keep up.
    void setDroppedRows(std::uint64_t rows) { m_meta.droppedRows = rows; }
    /// Where the distance of rows changed on the way; empty: nowhere.
    void setRates(std::vector<RateChange> rates) { m_meta.rates = std::move(rates); }
    Result<void> finish();
    /// Ends without a name: the partial file stays when there are rows in it, else nothing is left. Says
    /// whether it stays.
    bool abandon();
    /// Ends and leaves nothing.
    void discard();

    std::uint64_t rows() const { return m_meta.rows; }
    const std::string& partialPath() const { return m_partial; }
    /// Where an older interrupted recording is now; empty when there was none.
    const std::string& movedAside() const { return m_movedAside; }

private:
    RecordingWriter(const std::string& path, WriterOptions options, RecordingMeta meta);
    Result<void> open();
    Result<void> put(const std::string& text);
    void removeWorkingFiles();

    WriterOptions m_options;
    std::string m_path;
    std::string m_partial;
    std::string m_metaPartial;
    std::string m_movedAside;
    RecordingMeta m_meta;
    QFile m_file;
    QCryptographicHash m_hash;
    std::string m_text;
    std::optional<Error> m_error;
    std::unique_ptr<BackgroundFlush> m_flush; ///< before the file: it uses its handle
};

/// A whole recording at once; on an error nothing is left behind and an older file stays. Errors: as above.
Result<void> writeRecordingFile(const std::string& path, const Recording& recording, RecordingMeta meta);
/// The same with every number in all its digits: what was read, not measured.
Result<void> writeExactRecordingFile(const std::string& path, const Recording& recording, RecordingMeta meta,
                                     const std::string& suffix = ".partial");

} // namespace halbench::devices
