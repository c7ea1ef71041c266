#include "app/workbench/file_queue.h"

#include <cstdio>

namespace halbench::app {

FileQueue::FileQueue(QObject* parent) : QObject(parent) {}

FileQueue::~FileQueue() {
    {
        const std::lock_guard lock(m_mutex);
        m_isClosing = true;
    }
    m_wake.notify_one();
    if (m_thread.joinable()) {
        m_thread.join();
    }
    for (const auto& [number, error] : m_untold) {
        std::fprintf(stderr, "halbench: %s; %s\n", error.message.c_str(), error.hint.c_str());
    }
}

void FileQueue::add(Job job) {
    {
        const std::lock_guard lock(m_mutex);
        m_jobs.push_back(std::move(job));
    }
    if (!m_thread.joinable()) { // a window has dozens of queues, most of which never get a job
        m_thread = std::thread([this] { serve(); });
    }
    m_wake.notify_one();
}

void FileQueue::serve() {
    for (;;) {
        Job job;
        {
            std::unique_lock lock(m_mutex);
            m_wake.wait(lock, [this] { return m_isClosing || !m_jobs.empty(); });
            if (m_jobs.empty()) {
                return;
            }
            job = std::move(m_jobs.front());
            m_jobs.pop_front();
        }
        job();
    }
}

void FileQueue::noteFailure(std::uint64_t number, const Error& error) {
    const std::lock_guard lock(m_mutex);
    m_untold[number] = error;
}

void FileQueue::noteTold(std::uint64_t number) {
    const std::lock_guard lock(m_mutex);
    m_untold.erase(number);
}

} // namespace halbench::app
