#include "app/window/window_application.h"

#include <QKeyEvent>

namespace halbench::app {

bool WindowApplication::notify(QObject* receiver, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress) {
        keyComing(*static_cast<QKeyEvent*>(event));
    }
    return QApplication::notify(receiver, event);
}

} // namespace halbench::app
