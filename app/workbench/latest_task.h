#pragma once

#include <QObject>

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace halbench::app {

/// Computes on a thread of its own and answers on the GUI thread; only the newest question is answered, one
/// that waits behind it is never begun. Thread: GUI. The destructor waits for the one that computes.
class LatestTask : public QObject {
public:
    explicit LatestTask(QObject* parent = nullptr);
    ~LatestTask() override;

    /// `work()` must not touch what others use; `then(answer)` follows on the GUI thread unless another
    /// question came in between.
    template <typename Work, typename Then>
    void run(Work work, Then then);

    /// Nothing that was asked so far is answered any more.
    void cancel();

    /// Whether an answer is still to come.
    bool isBusy() const { return m_isBusy; }

private:
    void start(std::function<void()> job);
    void serve();

    std::uint64_t m_newest = 0; ///< GUI thread only
    bool m_isBusy = false;      ///< GUI thread only

    std::mutex m_mutex; ///< guards the two below
    std::optional<std::function<void()>> m_waiting;
    bool m_isClosing = false;
    std::condition_variable m_wake;
    std::thread m_thread; ///< last: starts when everything else is there
};

template <typename Work, typename Then>
void LatestTask::run(Work work, Then then) {
    const std::uint64_t number = ++m_newest;
    m_isBusy = true;
    start([this, number, work = std::move(work), then = std::move(then)] {
        auto answer = std::make_shared<decltype(work())>(work());
        QMetaObject::invokeMethod(
            this,
            [this, number, answer, then] {
                if (number == m_newest) {
                    m_isBusy = false;
                    then(std::move(*answer));
                }
            },
            Qt::QueuedConnection);
    });
}

} // namespace halbench::app
