#pragma once

#include "control/base/result.h"
#include "devices/recording/disk_access.h"
#include "devices/recording/recording_chunks.h"

#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

namespace halbench::devices {

/// Brings what was written to a file to the disk once per interval, on a thread of its own, and then notes
/// the checksum of that chunk in the journal: the writer never waits for the disk, and a power loss takes at
/// most one interval. All functions belong to the thread of the writer.
class BackgroundFlush {
public:
    /// `path`: for the errors; `handle`: of the open file. Errors of the journal: as of writing, see error().
    BackgroundFlush(std::string path, int handle, const std::string& journalPath, double interval_s,
                    DiskAccess disk);
    /// As stop(false).
    ~BackgroundFlush();
    BackgroundFlush(const BackgroundFlush&) = delete;
    BackgroundFlush& operator=(const BackgroundFlush&) = delete;

    /// Whole lines that the system has now.
    void add(std::string_view lines);
    /// The first failure of the disk; nothing is flushed after it.
    std::optional<Error> error() const;
    /// Ends the thread; `isLast`: after one more flush of what is open.
    void stop(bool isLast);

private:
    void run(double interval_s);
    void flush(const RecordingChunk& chunk);
    void fail(const QFileDevice& file);

    const std::string m_path;
    const int m_handle;
    const DiskAccess m_disk;
    QFile m_journal;

    mutable std::mutex m_mutex; ///< guards the five below
    std::condition_variable m_wake;
    RecordingChunk m_open;
    bool m_isStopping = false;
    bool m_isLastWanted = false;
    std::optional<Error> m_error;

    std::thread m_thread; ///< last: starts when everything else is there
};

} // namespace halbench::devices
