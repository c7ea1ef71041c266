#include "app/workbench/stop_latch.h"

#include <QGuiApplication>
#include <QStyleHints>

#include <algorithm>
#include <utility>

namespace halbench::app {

namespace {

constexpr int LockOut_ms = 1000;

} // namespace

StopLatch::StopLatch(DeviceSession& session) : m_session(session) {
    m_lockOut.setSingleShot(true);
    m_lockOut.setInterval(LockOut_ms);
    connect(&m_lockOut, &QTimer::timeout, this, &StopLatch::changed);
    m_afterRelease.setSingleShot(true);
    connect(&m_afterRelease, &QTimer::timeout, this, &StopLatch::changed);
    connect(&m_session, &DeviceSession::reportChanged, this, &StopLatch::onReport);
    connect(&m_session, &DeviceSession::stateChanged, this, &StopLatch::onState);
}

void StopLatch::setLockOut_ms(int lockOut_ms) {
    m_lockOut.setInterval(lockOut_ms);
}

void StopLatch::onReport() {
    refresh();
    m_wasArmed = m_session.report().board.isArmed;
}

void StopLatch::onState() {
    m_wasArmed = true; // a board that is found latched may have been
    refresh();
}

void StopLatch::refresh() {
    const devices::DeviceState& board = m_session.report().board;
    const bool isLatched =
        m_session.state() == SessionState::Connected && (board.isStopLatched || board.fault != 0);
    const std::uint64_t stops = m_session.stops();
    const bool isPressed = std::exchange(m_stops, stops) != stops;
    if (std::exchange(m_isLatched, isLatched) == isLatched) {
        if (isLatched && isPressed) { // who presses again is not done with stopping
            m_lockOut.start();
            Q_EMIT changed();
        }
        return;
    }
    m_hasStopped = m_wasArmed || board.fault != 0;
    if (isLatched) {
        m_lockOut.start();
        m_afterRelease.stop();
    } else {
        m_lockOut.stop();
        m_afterRelease.start(
            std::max(m_lockOut.interval(), QGuiApplication::styleHints()->mouseDoubleClickInterval()));
    }
    Q_EMIT changed();
}

void StopLatch::release(std::function<void(const Result<void>&)> then) {
    refresh(); // a stop of this moment
    if (isLocked()) {
        then(failure(ErrorCode::Refused, tr("The stop cannot be released yet.").toStdString(),
                     tr("Wait a moment, check the actuator, then release.").toStdString()));
        return;
    }
    m_session.requestUnlessStopped([](devices::Device& device) { return device.clearStop(); },
                                   std::move(then));
}

} // namespace halbench::app
