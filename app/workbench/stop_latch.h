#pragma once

#include "app/session/device_session.h"

#include <QObject>
#include <QTimer>

#include <functional>

namespace halbench::app {

/// The stop or fault that the board holds latched, and the time after it, and after every further stop, in
/// which it cannot be released, so that hammering on a control never does. Every control that releases uses
/// this one. Thread: GUI.
class StopLatch : public QObject {
    Q_OBJECT
public:
    explicit StopLatch(DeviceSession& session);

    bool isLatched() const { return m_isLatched; }
    /// It stopped something: the board was armed when it came, as far as the window knows.
    bool hasStopped() const { return m_hasStopped; }
    bool isLocked() const { return m_lockOut.isActive(); }
    /// Released so lately that arming has to wait as long as the lock-out, at least a double click: a hand
    /// that clicks or types twice releases and does not arm too.
    bool isJustReleased() const { return m_afterRelease.isActive(); }
    void setLockOut_ms(int lockOut_ms);

    /// The purposeful act: releases the latch, arms nothing. Refused while it is locked.
    void release(std::function<void(const Result<void>&)> then);

Q_SIGNALS:
    void changed();

private:
    void onReport();
    void onState();
    void refresh();

    DeviceSession& m_session;
    bool m_isLatched = false;
    std::uint64_t m_stops = 0; ///< asked for, as seen last
    bool m_wasArmed = true;    ///< as the report before said
    bool m_hasStopped = true;
    QTimer m_lockOut;
    QTimer m_afterRelease;
};

} // namespace halbench::app
