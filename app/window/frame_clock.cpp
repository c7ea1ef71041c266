#include "app/window/frame_clock.h"

#include <QEvent>
#include <QWidget>

namespace halbench::app {

namespace {

constexpr int FramePeriod_ms = 33;
constexpr int MinimisedPeriod_ms = 200; // well below the second after which values are old

} // namespace

FrameClock::FrameClock(QWidget& window) : QTimer(&window), m_window(window) {
    setInterval(FramePeriod_ms);
    window.installEventFilter(this);
}

bool FrameClock::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::WindowStateChange) {
        setInterval(m_window.isMinimized() ? MinimisedPeriod_ms : FramePeriod_ms);
    }
    return QTimer::eventFilter(watched, event);
}

} // namespace halbench::app
