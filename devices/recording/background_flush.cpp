#include "devices/recording/background_flush.h"

#include "devices/recording/file_access.h"

#include <chrono>
#include <utility>

namespace halbench::devices {

BackgroundFlush::BackgroundFlush(std::string path, int handle, const std::string& journalPath,
                                 double interval_s, DiskAccess disk)
    : m_path(std::move(path)), m_handle(handle), m_disk(std::move(disk)),
      m_journal(QString::fromStdString(journalPath)) {
    if (!m_journal.open(QIODevice::WriteOnly | QIODevice::Unbuffered)) {
        fail(m_journal);
    }
    m_thread = std::thread([this, interval_s] { run(interval_s); });
}

BackgroundFlush::~BackgroundFlush() {
    stop(false);
}

void BackgroundFlush::add(std::string_view lines) {
    const std::lock_guard lock(m_mutex);
    m_open.octets += lines.size();
    m_open.crc = crc32(lines, m_open.crc);
}

std::optional<Error> BackgroundFlush::error() const {
    const std::lock_guard lock(m_mutex);
    return m_error;
}

void BackgroundFlush::stop(bool isLast) {
    if (!m_thread.joinable()) {
        return;
    }
    {
        const std::lock_guard lock(m_mutex);
        m_isStopping = true;
        m_isLastWanted = isLast;
    }
    m_wake.notify_one();
    m_thread.join();
    m_journal.close();
}

void BackgroundFlush::run(double interval_s) {
    const std::chrono::duration<double> interval(interval_s);
    for (;;) {
        RecordingChunk chunk;
        bool isStopping = false;
        {
            std::unique_lock lock(m_mutex);
            m_wake.wait_for(lock, interval, [this] { return m_isStopping; });
            isStopping = m_isStopping;
            if (!m_error && (!isStopping || m_isLastWanted)) {
                chunk = std::exchange(m_open, {});
            }
        }
        if (chunk.octets > 0) {
            flush(chunk);
        }
        if (isStopping) {
            return;
        }
    }
}

void BackgroundFlush::flush(const RecordingChunk& chunk) {
    const std::string line = chunkLine(chunk);
    const auto size = static_cast<qint64>(line.size());
    // First the rows, then their checksum: a checksum that is there has its rows.
    if (!m_disk.sync(m_handle) || m_journal.write(line.data(), size) != size) {
        fail(m_journal);
    }
}

void BackgroundFlush::fail(const QFileDevice& file) {
    const auto error = cannotWrite(m_path, file);
    const std::lock_guard lock(m_mutex);
    m_error = error.value();
}

} // namespace halbench::devices
