#include "widgets/controls/wheel_guard.h"

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QScrollBar>

namespace halbench::widgets {

namespace {

/// What is watched, when the wheel would change its value.
QWidget* valueField(QObject* watched) {
    const bool isField =
        qobject_cast<QAbstractSpinBox*>(watched) != nullptr || qobject_cast<QComboBox*>(watched) != nullptr ||
        (qobject_cast<QAbstractSlider*>(watched) != nullptr && qobject_cast<QScrollBar*>(watched) == nullptr);
    return isField ? static_cast<QWidget*>(watched) : nullptr;
}

} // namespace

WheelGuard::WheelGuard(QObject* parent) : QObject(parent) {
    qApp->installEventFilter(this);
}

bool WheelGuard::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::Wheel && event->type() != QEvent::Polish) {
        return QObject::eventFilter(watched, event);
    }
    QWidget* field = valueField(watched);
    if (field == nullptr) {
        return QObject::eventFilter(watched, event);
    }
    if (event->type() == QEvent::Polish) { // before it is shown
        if (field->focusPolicy() == Qt::WheelFocus) {
            field->setFocusPolicy(Qt::StrongFocus);
        }
        return QObject::eventFilter(watched, event);
    }
    if (field->hasFocus()) {
        return QObject::eventFilter(watched, event);
    }
    event->ignore(); // whoever is behind it scrolls
    return true;
}

} // namespace halbench::widgets
