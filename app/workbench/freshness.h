#pragma once

#include "app/session/device_session.h"

#include <QDateTime>
#include <QObject>
#include <QTimer>

namespace halbench::app {

/// Whether the values that are shown of the device are still being updated: they are old once nothing came
/// for a second, and at once when the device is gone. Nothing is old before the first value. Thread: GUI.
class Freshness : public QObject {
    Q_OBJECT

public:
    explicit Freshness(DeviceSession& session);

    void samplesCame();
    bool isStale() const { return m_isStale; }
    /// Values came, and not long ago.
    bool isFresh() const { return m_last.isValid() && !m_isStale; }
    /// Since when, on the wall's clock; empty while values are fresh.
    QString words() const;

Q_SIGNALS:
    void changed();

private:
    void onState();
    void setStale(bool isStale);

    DeviceSession& m_session;
    QTimer m_patience;
    QDateTime m_last; ///< when values came last
    bool m_isStale = false;
};

} // namespace halbench::app
