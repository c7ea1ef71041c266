#pragma once

#include "app/session/row_selection.h"
#include "control/base/result.h"
#include "control/base/sample_block.h"
#include "devices/recording/recording_meta.h"
#include "devices/recording/recording_writer.h"

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace halbench::app {

/// Settings of a recording: file, columns, length.
struct RecorderConfig {
    std::string path;                                  ///< of the CSV file; its sidecar lies beside it
    StreamLayout layout;                               ///< the columns; the distance of rows
    devices::RecordingMeta meta;                       ///< device, parameters, start
    std::size_t queue_rows = 120000;                   ///< what may wait for the disk: two minutes at 1 kHz
    double flushInterval_s = devices::FlushInterval_s; ///< what a power loss may take
    devices::DiskAccess disk = devices::realDisk();
    std::optional<double> end_s; ///< no row from then on, and the recording finishes by itself; on the
                                 ///< clock of the blocks
};

struct RecorderStatus {
    enum class State { Recording, Finishing, Done, Failed };
    State state = State::Recording;
    double elapsed_s = 0.0; ///< device time from the first row to the last
    std::uint64_t rows = 0; ///< on the disk
    std::uint64_t missingRows =
        0;                  ///< gaps of the time axis: lost on the link, a restart of the stream, dropped
    std::uint64_t gaps = 0; ///< stretches without rows
    double gaps_s = 0.0;    ///< how long they are together
    std::uint64_t droppedRows = 0; ///< of the stream, because the disk did not keep up
    std::optional<Error> error;    ///< why it failed; what was written stays as `path.partial`
};

/// Writes samples to a CSV file on a thread of its own while a device streams. The stream may change its
/// signals and its rate on the way: the columns stay, a signal that does not come is an empty field, and what
/// is missing is counted. A disk that is slow or full ends or thins the recording and disturbs nothing else.
/// push() comes from the connection thread, everything else from any.
class Recorder {
public:
    explicit Recorder(RecorderConfig config);
    /// Completes the file and waits for that.
    ~Recorder();
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    /// Returns at once.
    void push(TimedBlock block);
    /// Times on the clock of the blocks.
    void addMarker(double time_s, const std::string& text);
    void addChange(double time_s, const std::string& parameter, double value);
    /// No more rows; the file gets its name. Returns at once; status() tells when it is done.
    void finish();

    RecorderStatus status() const;
    const std::string& path() const { return m_config.path; }

private:
    struct Drop { ///< a stretch that the disk was too slow for
        double begin_s = 0.0;
        double end_s = 0.0;
        std::uint64_t rows = 0;
    };

    struct Waiting { ///< for the disk
        TimedBlock block;
        bool isAfterDrop = false;
    };

    void run();
    Result<void> write(devices::RecordingWriter& writer, const Waiting& waiting);
    Result<void> writeAll(devices::RecordingWriter& writer);
    devices::RecordingEvents events() const;
    void noteEvents(devices::RecordingWriter& writer) const;
    void keepEvents(devices::RecordingWriter& writer);
    void noteDrop(const TimedBlock& block);
    void end(const Result<void>& result);

    const RecorderConfig m_config;

    mutable std::mutex m_mutex; ///< guards the queue and the status
    std::condition_variable m_wake;
    std::deque<Waiting> m_queue;
    bool m_isAfterDrop = false; ///< the next block
    std::size_t m_queued_rows = 0;
    std::vector<devices::RecordingMeta::Marker> m_markers;
    std::vector<devices::RecordingMeta::ParameterChange> m_changes;
    std::vector<Drop> m_drops;
    RecorderStatus m_status;

    // Of the recorder's thread alone.
    RowSelection m_rows;
    std::size_t m_keptEvents = 0;         ///< with the sidecar that a recovery would find
    std::optional<double> m_eventsKept_s; ///< when, on the clock of the blocks

    std::thread m_thread; ///< last: starts when everything else is there
};

} // namespace halbench::app
