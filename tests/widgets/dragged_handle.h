#pragma once

#include <QApplication>
#include <QMouseEvent>
#include <QSplitter>
#include <QSplitterHandle>

namespace halbench::widgets {

/// The line before that part, dragged by the mouse.
inline void dragHandle(const QSplitter& splitter, int line, int by_px) {
    QSplitterHandle* handle = splitter.handle(line);
    const QPoint way = splitter.orientation() == Qt::Vertical ? QPoint(0, by_px) : QPoint(by_px, 0);
    const QPoint place(1, 1);
    const auto send = [handle](QEvent::Type type, QPoint at, Qt::MouseButton button,
                               Qt::MouseButtons buttons) {
        QMouseEvent event(type, at, handle->mapToGlobal(at), button, buttons, Qt::NoModifier);
        QApplication::sendEvent(handle, &event);
    };
    send(QEvent::MouseButtonPress, place, Qt::LeftButton, Qt::LeftButton);
    send(QEvent::MouseMove, place + way, Qt::NoButton, Qt::LeftButton);
    send(QEvent::MouseButtonRelease, place, Qt::LeftButton, Qt::NoButton); // it is below the mouse now
}

} // namespace halbench::widgets
