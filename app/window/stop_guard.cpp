#include "app/window/stop_guard.h"

#include <QApplication>
#include <QKeyEvent>

#include <utility>

namespace halbench::app {

StopGuard::StopGuard(QObject* parent) : QObject(parent) {
    qApp->installEventFilter(this);
}

StopGuard::~StopGuard() {
    qApp->removeEventFilter(this);
}

/// A key comes first as an offer to shortcuts, then as a key press unless a shortcut took it: the first of
/// the two that passes here stops. Stopping twice does no harm.
bool StopGuard::eventFilter(QObject* watched, QEvent* event) {
    const bool isKey = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
    if (isKey && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        stopRequested();
        if (event->type() == QEvent::ShortcutOverride && !static_cast<QKeyEvent*>(event)->isAutoRepeat()) {
            tellOnce();
        }
    }
    return QObject::eventFilter(watched, event);
}

/// The offer passes here for every widget from the one with the focus up to its window.
void StopGuard::tellOnce() {
    if (!std::exchange(m_isTold, true)) {
        QMetaObject::invokeMethod(
            this, [this] { m_isTold = false; }, Qt::QueuedConnection);
        escapePressed();
    }
}

} // namespace halbench::app
