#pragma once

#include "control/base/sample_block.h"
#include "devices/acquisition/recording_meta.h"

#include <QtCore/QCryptographicHash>
#include <QtCore/QFile>

#include <memory>
#include <string>
#include <vector>

namespace halbench::devices {

/// Writes a recording as it comes, as `path.partial`, flushed at every block; finish() gives it its name and
/// its sidecar. A recording that ended otherwise stays as `path.partial` for recoverRecording(). Never drops
/// a row silently: the first error stays and finish() repeats it. Thread: one.
class RecordingWriter {
public:
    /// Folders are created. Errors: FileSystem with path and cause.
    static Result<std::unique_ptr<RecordingWriter>> create(const std::string& path,
                                                           const StreamLayout& layout, RecordingMeta meta);

    Result<void> append(const SampleBlock& block);
    void addMarker(double time_s, const std::string& text);
    void addChange(double time_s, const std::string& name, double value);
    Result<void> finish();

private:
    RecordingWriter(std::string path, RecordingMeta meta);
    Result<void> put(const std::string& text);

    std::string m_path;
    RecordingMeta m_meta;
    QFile m_file;
    QCryptographicHash m_hash;
    std::string m_text;
    std::optional<Error> m_error;
};

/// A whole recording at once; on an error nothing is left behind and an older file stays. Errors: FileSystem.
Result<void> writeRecordingFile(const std::string& path, const Recording& recording, RecordingMeta meta);

/// A recording read back with what its sidecar says; without a sidecar the signals are named after the
/// columns.
struct RecordedFile {
    Recording recording;
    RecordingMeta meta;
    bool hasMeta = false;
    std::vector<std::string> warnings; ///< e.g. the data were changed since
};
/// Errors: FileSystem, InvalidInput with line and column.
Result<RecordedFile> readRecordingFile(const std::string& path);

/// Makes a complete recording of `path.partial` that an interrupted program left: the last line is dropped
/// when it is not complete. Gives the number of rows. Errors: FileSystem, InvalidInput.
Result<std::uint64_t> recoverRecording(const std::string& path);

} // namespace halbench::devices
