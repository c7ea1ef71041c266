#pragma once

#include "app/session/device_session.h"

#include <QObject>

#include <map>
#include <string>
#include <vector>

namespace halbench::app {

/// Which signals the panels want to see. Their union is streamed at the fastest rate that all of them and the
/// link allow; it starts with every connection. Thread: GUI.
class LiveSignals : public QObject {
    Q_OBJECT

public:
    explicit LiveSignals(DeviceSession& session, QObject* parent = nullptr);

    /// Replaces what this client wanted before; forgotten when the client is destroyed. Signals that the
    /// device does not have are left out.
    void want(const QObject* client, std::vector<std::string> names);

    /// Signals that are not the device's own, and those of the device that each needs: who wants one gets
    /// these.
    void setSources(std::map<std::string, std::vector<std::string>> sources);

    const std::vector<std::string>& streamed() const { return m_streamed; } ///< in the catalogue's order
    double rate_Hz() const { return m_rate_Hz; }
    /// Wanted, but not streamed: the device samples them at another event than the others, or at none.
    const std::vector<std::string>& leftOut() const { return m_leftOut; }

Q_SIGNALS:
    void changed();

private:
    void restart();
    bool isWanted(const std::string& name) const;
    bool isNeeded(const std::string& name) const;

    DeviceSession& m_session;
    std::map<const QObject*, std::vector<std::string>> m_wanted;
    std::map<std::string, std::vector<std::string>> m_sources;
    std::vector<std::string> m_streamed;
    std::vector<std::string> m_leftOut;
    double m_rate_Hz = 0.0;
};

} // namespace halbench::app
