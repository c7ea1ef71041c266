#include "app/session/recorder.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace halbench::app {

namespace {

/// "Now" of somebody who marks a moment is as old as the last report of the device.
constexpr double ReportAge_s = 0.5;

/// Drops that follow each other so closely are told as one.
constexpr double DropDistance_s = 1.0;

} // namespace

Recorder::Recorder(RecorderConfig config)
    : m_config(std::move(config)),
      m_rows(std::make_shared<const StreamLayout>(m_config.layout), m_config.end_s),
      m_thread([this] { run(); }) {}

Recorder::~Recorder() {
    finish();
    m_thread.join();
}

void Recorder::push(TimedBlock block) {
    {
        const std::lock_guard lock(m_mutex);
        if (m_status.state != RecorderStatus::State::Recording) {
            return;
        }
        if (m_queued_rows + block.rows() > m_config.queue_rows) {
            noteDrop(block);
            return;
        }
        m_queued_rows += block.rows();
        const bool isLast = m_config.end_s && block.rows() > 0 && block.end_s() >= *m_config.end_s;
        m_queue.push_back({std::move(block), std::exchange(m_isAfterDrop, false)});
        if (isLast) {
            m_status.state = RecorderStatus::State::Finishing;
        }
    }
    m_wake.notify_one();
}

void Recorder::noteDrop(const TimedBlock& block) {
    if (block.rows() == 0) {
        return;
    }
    m_isAfterDrop = true;
    m_status.droppedRows += block.rows();
    const double begin_s = block.begin_s();
    if (m_drops.empty() || begin_s < m_drops.back().begin_s ||
        begin_s > m_drops.back().end_s + DropDistance_s) {
        m_drops.push_back({begin_s, begin_s, 0});
    }
    m_drops.back().end_s = block.end_s();
    m_drops.back().rows += block.rows();
}

void Recorder::addMarker(double time_s, const std::string& text) {
    const std::lock_guard lock(m_mutex);
    m_markers.push_back({time_s, text});
}

void Recorder::addChange(double time_s, const std::string& parameter, double value) {
    const std::lock_guard lock(m_mutex);
    m_changes.push_back({time_s, parameter, value});
}

void Recorder::finish() {
    {
        const std::lock_guard lock(m_mutex);
        if (m_status.state == RecorderStatus::State::Recording) {
            m_status.state = RecorderStatus::State::Finishing;
        }
    }
    m_wake.notify_one();
}

RecorderStatus Recorder::status() const {
    const std::lock_guard lock(m_mutex);
    return m_status;
}

void Recorder::run() {
    devices::WriterOptions options;
    options.flushInterval_s = m_config.flushInterval_s;
    options.disk = m_config.disk;
    auto writer =
        devices::RecordingWriter::create(m_config.path, m_config.layout, m_config.meta, std::move(options));
    if (!writer) {
        end(failure(writer.error()));
        return;
    }
    Result<void> written = writeAll(**writer);
    if (written) {
        noteEvents(**writer);
        written = (*writer)->finish();
    }
    if (!written) {
        (*writer)->abandon(); // what was written stays under its working name
    }
    end(written);
}

/// Until the recording is finished and the queue is empty, or the disk refuses.
Result<void> Recorder::writeAll(devices::RecordingWriter& writer) {
    for (;;) {
        std::deque<Waiting> blocks;
        {
            std::unique_lock lock(m_mutex);
            m_wake.wait(lock, [this] {
                return !m_queue.empty() || m_status.state != RecorderStatus::State::Recording;
            });
            if (m_queue.empty()) {
                return {};
            }
            blocks.swap(m_queue);
            m_queued_rows = 0;
        }
        for (const Waiting& waiting : blocks) {
            if (Result<void> written = write(writer, waiting); !written) {
                return written;
            }
        }
        keepEvents(writer);
    }
}

Result<void> Recorder::write(devices::RecordingWriter& writer, const Waiting& waiting) {
    for (const SampleBlock& part : m_rows.take(waiting.block, waiting.isAfterDrop)) {
        if (Result<void> written = writer.append(part); !written) {
            return written;
        }
        const std::lock_guard lock(m_mutex);
        m_status.rows += part.rows();
        m_status.missingRows += part.lostRows;
        m_status.gaps += part.lostRows > 0 ? 1 : 0;
        m_status.gaps_s += static_cast<double>(part.lostRows) * m_rows.step_s();
        m_status.elapsed_s = m_rows.last_s() - m_rows.first_s().value_or(0.0);
    }
    return {};
}

/// On the recording's axis, as far as they belong to it.
devices::RecordingEvents Recorder::events() const {
    const std::lock_guard lock(m_mutex);
    const double first_s = m_rows.first_s().value_or(0.0);
    devices::RecordingEvents events;
    for (const auto& marker : m_markers) {
        if (marker.time_s >= first_s - ReportAge_s) { // else it is of a time before this recording
            events.markers.push_back({std::max(0.0, marker.time_s - first_s), marker.text});
        }
    }
    for (const auto& change : m_changes) {
        events.changes.push_back({std::max(0.0, change.time_s - first_s), change.name, change.value});
    }
    for (const Drop& drop : m_drops) {
        events.markers.push_back(
            {std::max(0.0, drop.begin_s - first_s), fmt::format("{} rows lost: disk too slow", drop.rows)});
    }
    events.droppedRows = m_status.droppedRows;
    events.rates = m_rows.rates();
    return events;
}

void Recorder::noteEvents(devices::RecordingWriter& writer) const {
    const devices::RecordingEvents all = events();
    for (const auto& marker : all.markers) {
        writer.addMarker(marker.time_s, marker.text);
    }
    for (const auto& change : all.changes) {
        writer.addChange(change.time_s, change.name, change.value);
    }
    writer.setDroppedRows(all.droppedRows);
    writer.setRates(all.rates);
}

/// What is new of them is with the disk as soon as the rows around it are. A sidecar that cannot be kept
/// costs no row: the one before serves a recovery, and the end of the recording writes its own.
void Recorder::keepEvents(devices::RecordingWriter& writer) {
    const devices::RecordingEvents all = events();
    const std::size_t count = all.markers.size() + all.changes.size() + all.rates.size();
    const double last_s = m_rows.last_s();
    const bool isDue =
        !m_eventsKept_s || last_s - *m_eventsKept_s >= m_config.flushInterval_s || last_s < *m_eventsKept_s;
    if (m_rows.first_s() && count != m_keptEvents && isDue) {
        m_eventsKept_s = last_s;
        m_keptEvents = count;
        (void)writer.keepEvents(all);
    }
}

void Recorder::end(const Result<void>& result) {
    const std::lock_guard lock(m_mutex);
    m_queue.clear();
    m_queued_rows = 0;
    m_status.state = result ? RecorderStatus::State::Done : RecorderStatus::State::Failed;
    if (!result) {
        m_status.error = result.error();
    }
}

} // namespace halbench::app
