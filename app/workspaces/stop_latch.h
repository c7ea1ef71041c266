#pragma once

#include "app/session/device_session.h"

#include <QObject>
#include <QTimer>

#include <functional>

namespace halbench::app {

/// The stop or fault that the board holds latched, and the time after it in which it cannot be released, so
/// that hammering on a control never does. Every control that releases uses this one. Thread: GUI.
class StopLatch : public QObject {
    Q_OBJECT
public:
    explicit StopLatch(DeviceSession& session);

    bool isLatched() const { return m_isLatched; }
    bool isLocked() const { return m_lockOut.isActive(); }
    void setLockOut_ms(int lockOut_ms);

    /// The purposeful act: releases the latch, arms nothing. Refused while it is locked.
    void release(std::function<void(const Result<void>&)> then);

Q_SIGNALS:
    void changed();

private:
    void onReport();

    DeviceSession& m_session;
    bool m_isLatched = false;
    QTimer m_lockOut;
};

} // namespace halbench::app
