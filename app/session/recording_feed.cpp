#include "app/session/recording_feed.h"

#include <utility>

namespace halbench::app {

namespace {

/// Kept beyond what was asked for: an event is found by the window, and a recording begins, a little later
/// than the rows come, which at twenty times the speed of the wall clock are many.
constexpr double Delay_s = 60.0;

std::optional<devices::HeldRows> heldFor(std::optional<double> length_s) {
    return length_s ? std::optional<devices::HeldRows>(*length_s + Delay_s) : std::nullopt;
}

} // namespace

void RecordingFeed::push(const TimedBlock& block) {
    const std::lock_guard lock(m_mutex);
    if (m_recorder) {
        m_recorder->push(block);
    } else if (m_held) {
        m_held->add(block);
    }
}

void RecordingFeed::keep(std::optional<double> length_s) {
    const std::lock_guard lock(m_mutex);
    m_length_s = length_s;
    m_held = heldFor(length_s);
}

std::optional<double> RecordingFeed::oldest_s() const {
    const std::lock_guard lock(m_mutex);
    return m_held ? m_held->oldest_s() : std::nullopt;
}

std::optional<double> RecordingFeed::newest_s() const {
    const std::lock_guard lock(m_mutex);
    return m_held ? m_held->newest_s() : std::nullopt;
}

std::size_t RecordingFeed::rows() const {
    const std::lock_guard lock(m_mutex);
    return m_held ? m_held->rows() : 0;
}

void RecordingFeed::give(std::shared_ptr<Recorder> recorder, double from_s) {
    const std::lock_guard lock(m_mutex); // a block that comes now waits for those from before it
    m_recorder = std::move(recorder);
    if (m_held) {
        for (const TimedBlock& block : m_held->from(from_s)) {
            m_recorder->push(block);
        }
    }
    m_held.reset();
}

void RecordingFeed::leave() {
    const std::lock_guard lock(m_mutex);
    m_recorder.reset();
    m_held = heldFor(m_length_s);
}

} // namespace halbench::app
