#pragma once

#include "control/base/result.h"

#include <QObject>

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

namespace halbench::app {

/// Reads and writes files on a thread of its own, one after the other, and answers on the GUI thread. Nothing
/// that was asked for is dropped: the destructor completes all of it, and says on the standard error output
/// which failed, because nobody else hears it any more. Thread: GUI.
class FileQueue : public QObject {
public:
    explicit FileQueue(QObject* parent = nullptr);
    ~FileQueue() override;

    /// `work() -> Result<T>` must not touch what others use; `then(Result<T>)` follows on the GUI thread.
    template <typename Work, typename Then>
    void run(Work work, Then then);

private:
    using Job = std::function<void()>;
    void add(Job job);
    void serve();
    void noteFailure(std::uint64_t number, const Error& error);
    void noteTold(std::uint64_t number);

    std::uint64_t m_count = 0; ///< GUI thread only

    std::mutex m_mutex; ///< guards the three below
    std::deque<Job> m_jobs;
    bool m_isClosing = false;
    std::map<std::uint64_t, Error> m_untold; ///< failures whose answer has not reached the GUI thread
    std::condition_variable m_wake;
    std::thread m_thread; ///< last: starts when everything else is there
};

template <typename Work, typename Then>
void FileQueue::run(Work work, Then then) {
    const std::uint64_t number = ++m_count;
    add([this, number, work = std::move(work), then = std::move(then)] {
        auto answer = std::make_shared<decltype(work())>(work());
        if (!*answer) {
            noteFailure(number, answer->error());
        }
        QMetaObject::invokeMethod(
            this,
            [this, number, answer, then] {
                noteTold(number);
                then(std::move(*answer));
            },
            Qt::QueuedConnection);
    });
}

} // namespace halbench::app
