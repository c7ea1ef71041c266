#include "app/session/gui_queue.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QEvent>

#include <utility>

namespace halbench::app {

void GuiQueue::add(std::function<void()> function) {
    {
        const std::lock_guard lock(m_mutex);
        m_functions.push_back(std::move(function));
    }
    QCoreApplication::postEvent(this, new QEvent(QEvent::User));
}

/// Looks at nothing of the event: it was made by another thread, and Qt's lock on it is not seen.
void GuiQueue::customEvent(QEvent*) {
    std::function<void()> function;
    {
        const std::lock_guard lock(m_mutex);
        function = std::move(m_functions.front()); // one event a function
        m_functions.pop_front();
    }
    function();
}

} // namespace halbench::app
