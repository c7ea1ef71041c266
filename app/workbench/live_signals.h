#pragma once

#include "app/session/device_session.h"

#include <QObject>

#include <map>
#include <string>
#include <vector>

namespace halbench::app {

/// Which signals the panels want to see. Their union is streamed a thousand times a second, over a serial
/// line a hundred times, faster where somebody needs more and as far as board and link carry it
/// (devices/acquisition/stream_rate.h); it starts with every connection. Thread: GUI.
class LiveSignals : public QObject {
    Q_OBJECT

public:
    explicit LiveSignals(DeviceSession& session, QObject* parent = nullptr);

    /// Replaces what this client wanted before; forgotten when the client is destroyed. Signals that the
    /// device does not have are left out.
    void want(const QObject* client, std::vector<std::string> names);

    /// Rows a second that this client needs, forgotten with it; 0: what is usual. More than the device and
    /// the link carry is lowered to that.
    void wantRate(const QObject* client, double rate_Hz);
    /// The most they carry of these signals and what is streamed.
    double greatestRate_Hz(const std::vector<std::string>& more = {}) const;

    /// Signals that are not the device's own, and those of the device that each needs: who wants one gets
    /// these.
    void setSources(std::map<std::string, std::vector<std::string>> sources);

    const std::vector<std::string>& streamed() const { return m_streamed; } ///< in the catalogue's order
    double rate_Hz() const { return m_rate_Hz; }
    double usualRate_Hz() const { return m_usual_Hz; } ///< while nobody needs more
    /// Wanted, but not streamed: the device samples them at another event than the others, or at none.
    const std::vector<std::string>& leftOut() const { return m_leftOut; }

    /// While held, the stream stays as it is, whatever is wanted: a stream that begins anew leaves a gap in
    /// what is being recorded. What is wanted meanwhile comes when it is let go.
    void setHeld(bool isHeld);
    /// Wanted, and waiting for that.
    const std::vector<std::string>& postponed() const { return m_postponed; }

Q_SIGNALS:
    void changed();

private:
    void restart();
    void know(const QObject* client);
    double rateFor(const std::vector<const SignalSpec*>& specs, const std::vector<std::string>& names) const;
    void postpone(const std::vector<std::string>& names);
    bool isWanted(const std::string& name) const;
    bool isNeeded(const std::string& name) const;

    DeviceSession& m_session;
    std::map<const QObject*, std::vector<std::string>> m_wanted;
    std::map<const QObject*, double> m_rates_Hz;
    std::map<std::string, std::vector<std::string>> m_sources;
    std::vector<std::string> m_streamed;
    std::vector<std::string> m_leftOut;
    std::vector<std::string> m_postponed;
    bool m_isHeld = false;
    double m_rate_Hz = 0.0;
    double m_usual_Hz = 0.0;
};

} // namespace halbench::app
