#pragma once

#include <QtCore/QObject>

#include <deque>
#include <functional>
#include <mutex>

namespace halbench::app {

/// Functions that any thread hands to the thread this object lives on: one per turn of its event loop, in the
/// order they came. What has not run when the object goes is dropped. Unlike a functor posted through Qt, the
/// functions change threads under a lock of ours, which a thread sanitizer sees.
class GuiQueue : public QObject {
public:
    /// Thread: any.
    void add(std::function<void()> function);

protected:
    void customEvent(QEvent* event) override;

private:
    std::mutex m_mutex; ///< guards the functions
    std::deque<std::function<void()>> m_functions;
};

} // namespace halbench::app
