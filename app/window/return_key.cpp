#include "app/window/return_key.h"

#include "widgets/controls/stop_button.h"

#include <QApplication>
#include <QKeyEvent>
#include <QPushButton>
#include <QToolButton>

namespace halbench::app {

namespace {

bool isPlainReturn(const QKeyEvent& event) {
    const bool isReturn = event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
    return isReturn && (event.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
}

/// Whether Return would do nothing there without us.
bool needsHelp(QObject* watched) {
    if (qobject_cast<widgets::StopButton*>(watched) != nullptr) {
        return false;
    }
    const auto* push = qobject_cast<QPushButton*>(watched);
    return push != nullptr ? !push->autoDefault() && !push->isDefault()
                           : qobject_cast<QToolButton*>(watched) != nullptr;
}

} // namespace

ReturnKey::ReturnKey(QObject* parent) : QObject(parent) {
    qApp->installEventFilter(this);
}

bool ReturnKey::eventFilter(QObject* watched, QEvent* event) {
    const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease;
    if (!isKey || !needsHelp(watched)) {
        return QObject::eventFilter(watched, event);
    }
    const auto& key = static_cast<const QKeyEvent&>(*event);
    if (!isPlainReturn(key)) {
        return QObject::eventFilter(watched, event);
    }
    QKeyEvent space(key.type(), Qt::Key_Space, Qt::NoModifier, QStringLiteral(" "), key.isAutoRepeat());
    QApplication::sendEvent(watched, &space);
    event->accept();
    return true;
}

} // namespace halbench::app
