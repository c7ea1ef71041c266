#include "app/workbench/latest_task.h"

namespace halbench::app {

LatestTask::LatestTask(QObject* parent) : QObject(parent) {}

LatestTask::~LatestTask() {
    {
        const std::lock_guard lock(m_mutex);
        m_isClosing = true;
        m_waiting.reset();
    }
    m_wake.notify_one();
    if (m_thread.joinable()) {
        m_thread.join();
    }
}

void LatestTask::cancel() {
    ++m_newest;
    m_isBusy = false;
    const std::lock_guard lock(m_mutex);
    m_waiting.reset();
}

void LatestTask::start(std::function<void()> job) {
    {
        const std::lock_guard lock(m_mutex);
        m_waiting = std::move(job);
    }
    if (!m_thread.joinable()) { // a window has dozens of tasks, most of which are never asked
        m_thread = std::thread([this] { serve(); });
    }
    m_wake.notify_one();
}

void LatestTask::serve() {
    for (;;) {
        std::function<void()> job;
        {
            std::unique_lock lock(m_mutex);
            m_wake.wait(lock, [this] { return m_isClosing || m_waiting; });
            if (m_isClosing) {
                return;
            }
            job = std::move(*m_waiting);
            m_waiting.reset();
        }
        job();
    }
}

} // namespace halbench::app
