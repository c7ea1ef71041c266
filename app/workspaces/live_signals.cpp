#include "app/workspaces/live_signals.h"

#include <algorithm>

namespace halbench::app {

namespace {

constexpr double FastestRate_Hz = 1000.0;
/// 15 signals of 4 octets at 115200 Bd leave room for 167 rows a second (resources/help/protocol.md 3.14).
constexpr double SerialRate_Hz = 100.0;

double rateFor(const devices::DeviceInfo& info, const std::vector<const SignalSpec*>& specs) {
    double rate_Hz = info.transport == "serial" ? SerialRate_Hz : FastestRate_Hz;
    for (const SignalSpec* spec : specs) {
        rate_Hz = std::min(rate_Hz, spec->maxRate_Hz);
    }
    return rate_Hz;
}

} // namespace

LiveSignals::LiveSignals(DeviceSession& session, QObject* parent) : QObject(parent), m_session(session) {
    connect(&m_session, &DeviceSession::stateChanged, this, [this] {
        if (m_session.state() != SessionState::Reconnecting && m_session.returns() == 0) {
            m_streamed.clear(); // what a device that comes back sent before, it sends again by itself
            m_rate_Hz = 0.0;
        }
        restart();
    });
}

void LiveSignals::want(const QObject* client, std::vector<std::string> names) {
    if (m_wanted.count(client) == 0) {
        connect(client, &QObject::destroyed, this, [this, client] {
            m_wanted.erase(client);
            restart();
        });
    }
    m_wanted[client] = std::move(names);
    restart();
}

bool LiveSignals::isWanted(const std::string& name) const {
    return std::any_of(m_wanted.begin(), m_wanted.end(), [&](const auto& wish) {
        return std::find(wish.second.begin(), wish.second.end(), name) != wish.second.end();
    });
}

void LiveSignals::restart() {
    if (m_session.state() != SessionState::Connected) {
        return;
    }
    std::vector<std::string> names;
    std::vector<const SignalSpec*> specs;
    for (const SignalSpec& spec : m_session.catalogue().signals) {
        if (isWanted(spec.name)) {
            names.push_back(spec.name);
            specs.push_back(&spec);
        }
    }
    const double rate_Hz = rateFor(m_session.info(), specs);
    if (names == m_streamed && rate_Hz == m_rate_Hz) {
        return;
    }
    m_streamed = std::move(names);
    m_rate_Hz = rate_Hz;
    m_session.setLiveStream(m_streamed, m_rate_Hz);
    Q_EMIT changed();
}

} // namespace halbench::app
