#pragma once

#include "app/session/recorder.h"
#include "devices/recording/held_rows.h"

#include <memory>
#include <mutex>
#include <optional>

namespace halbench::app {

/// What lies between the stream and the recorder: it keeps the newest rows in memory until a recorder comes,
/// and gives it those from before and all that follow, each once and in order. push() comes from the
/// connection thread, everything else from any.
class RecordingFeed {
public:
    void push(const TimedBlock& block);

    /// So much is kept from now on; nothing: no rows are kept. What was kept is forgotten.
    void keep(std::optional<double> length_s);
    /// How far back the rows go that are kept, and the newest of them.
    std::optional<double> oldest_s() const;
    std::optional<double> newest_s() const;
    std::size_t rows() const;

    /// The rows from a time on go to the recorder, and so does what comes.
    void give(std::shared_ptr<Recorder> recorder, double from_s);
    /// Nothing more goes to it; rows are kept anew.
    void leave();

private:
    mutable std::mutex m_mutex;
    std::optional<double> m_length_s;
    std::optional<devices::HeldRows> m_held; ///< while rows are kept
    std::shared_ptr<Recorder> m_recorder;
};

} // namespace halbench::app
