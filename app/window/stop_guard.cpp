#include "app/window/stop_guard.h"

#include "app/window/window_application.h"

#include <QApplication>
#include <QKeyEvent>

#include <utility>

namespace halbench::app {

StopGuard::StopGuard(QObject* parent) : QObject(parent) {
    if (const auto* application = qobject_cast<WindowApplication*>(qApp)) {
        connect(application, &WindowApplication::keyComing, this, &StopGuard::onKey);
    } else {
        qApp->installEventFilter(this);
    }
}

StopGuard::~StopGuard() {
    qApp->removeEventFilter(this);
}

void StopGuard::setNothingToStop(std::function<bool()> isNothingToStop) {
    m_isNothingToStop = std::move(isNothingToStop);
}

bool StopGuard::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress) {
        onKey(*static_cast<QKeyEvent*>(event));
    }
    return QObject::eventFilter(watched, event);
}

/// A key comes first as an offer to shortcuts, then as a key press unless a shortcut took it: the first of
/// the two that passes here stops. Stopping twice does no harm.
void StopGuard::onKey(const QKeyEvent& event) {
    if (event.key() != Qt::Key_Escape) {
        return;
    }
    if (m_isNothingToStop && m_isNothingToStop()) {
        return;
    }
    stopRequested();
    if (event.type() == QEvent::ShortcutOverride && !event.isAutoRepeat()) {
        tellOnce();
    }
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
