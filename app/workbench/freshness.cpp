#include "app/workbench/freshness.h"

#include "app/workbench/wall_clock.h"

#include <QLocale>

#include <algorithm>
#include <utility>

namespace halbench::app {

namespace {

constexpr int Patience_ms = 1000; ///< the slowest stream of the panels sends many rows in it

/// Of a time that runs slower than the wall clock's, rows come as much later.
int patience_ms(double speed_ratio) {
    constexpr double Longest_ms = 60000.0;
    const bool isSlow = speed_ratio > 0.0 && speed_ratio < 1.0;
    return isSlow ? static_cast<int>(std::min(Patience_ms / speed_ratio, Longest_ms)) : Patience_ms;
}

} // namespace

Freshness::Freshness(DeviceSession& session) : m_session(session) {
    m_patience.setSingleShot(true);
    m_patience.setInterval(Patience_ms);
    connect(&m_patience, &QTimer::timeout, this, [this] { setStale(true); });
    connect(&m_session, &DeviceSession::stateChanged, this, &Freshness::onState);
}

void Freshness::samplesCame() {
    m_last = wallClock();
    if (m_session.state() == SessionState::Connected) { // what was still on its way is the last there is
        m_patience.start(patience_ms(m_session.pace().speed_ratio));
        setStale(false);
    }
}

void Freshness::onState() {
    m_patience.stop();
    if (m_session.state() == SessionState::Connected) {
        m_last = {}; // another history begins
    }
    setStale(m_last.isValid());
}

void Freshness::setStale(bool isStale) {
    if (std::exchange(m_isStale, isStale) != isStale) {
        Q_EMIT changed();
    }
}

QString Freshness::words() const {
    return m_isStale ? tr("No new values since %1")
                           .arg(QLocale().toString(m_last.toLocalTime().time(), QStringLiteral("HH:mm:ss")))
                     : QString();
}

} // namespace halbench::app
