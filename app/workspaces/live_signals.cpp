#include "app/workspaces/live_signals.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

namespace halbench::app {

namespace {

constexpr double FastestRate_Hz = 1000.0;
/// 15 signals of 4 octets at 115200 Bd leave room for 167 rows a second (resources/help/protocol.md 3.14).
constexpr double SerialRate_Hz = 100.0;

/// A whole part of the rate that all of them have.
double rateFor(const devices::DeviceInfo& info, const std::vector<const SignalSpec*>& specs) {
    const double most_Hz = info.transport == "serial" ? SerialRate_Hz : FastestRate_Hz;
    double common_Hz = specs.empty() ? most_Hz : specs.front()->maxRate_Hz;
    for (const SignalSpec* spec : specs) {
        common_Hz = std::min(common_Hz, spec->maxRate_Hz);
    }
    return common_Hz / std::max(1.0, std::ceil(common_Hz / most_Hz));
}

bool isSampledAt(const SignalSpec& spec, int event) {
    return spec.events.empty() ||
           std::find(spec.events.begin(), spec.events.end(), event) != spec.events.end();
}

/// The event that carries the most of them, of equal ones the first met; nothing where no signal names one.
std::optional<int> fullestEvent(const std::vector<const SignalSpec*>& specs) {
    std::optional<int> fullest;
    std::ptrdiff_t most = 0;
    for (const SignalSpec* spec : specs) {
        for (const int event : spec->events) {
            const auto carried = std::count_if(specs.begin(), specs.end(), [event](const SignalSpec* one) {
                return isSampledAt(*one, event);
            });
            if (carried > most) {
                most = carried;
                fullest = event;
            }
        }
    }
    return fullest;
}

/// Takes out and names what cannot be streamed with the others: a row is one moment of one periodic event.
std::vector<std::string> takeOut(std::vector<const SignalSpec*>& specs) {
    const auto isPeriodic = [](const SignalSpec* spec) { return spec->maxRate_Hz > 0.0; };
    std::vector<const SignalSpec*> periodic;
    std::copy_if(specs.begin(), specs.end(), std::back_inserter(periodic), isPeriodic);
    const std::optional<int> event = fullestEvent(periodic);
    std::vector<const SignalSpec*> kept;
    std::vector<std::string> leftOut;
    for (const SignalSpec* spec : specs) {
        if (isPeriodic(spec) && (!event || isSampledAt(*spec, *event))) {
            kept.push_back(spec);
        } else {
            leftOut.push_back(spec->name);
        }
    }
    specs = std::move(kept);
    return leftOut;
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
            // Later: who listens may be what is being destroyed just now.
            QMetaObject::invokeMethod(
                this, [this] { restart(); }, Qt::QueuedConnection);
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

bool LiveSignals::isNeeded(const std::string& name) const {
    return isWanted(name) || std::any_of(m_sources.begin(), m_sources.end(), [&](const auto& entry) {
               const auto& [derived, needed] = entry;
               return isWanted(derived) && std::find(needed.begin(), needed.end(), name) != needed.end();
           });
}

void LiveSignals::setSources(std::map<std::string, std::vector<std::string>> sources) {
    m_sources = std::move(sources);
    restart();
}

void LiveSignals::restart() {
    if (m_session.state() != SessionState::Connected) {
        return;
    }
    std::vector<const SignalSpec*> specs;
    for (const SignalSpec& spec : m_session.catalogue().signals) {
        if (isNeeded(spec.name)) {
            specs.push_back(&spec);
        }
    }
    const std::vector<std::string> leftOut = std::exchange(m_leftOut, takeOut(specs));
    std::vector<std::string> names;
    for (const SignalSpec* spec : specs) {
        names.push_back(spec->name);
    }
    const double rate_Hz = rateFor(m_session.info(), specs);
    if (names == m_streamed && rate_Hz == m_rate_Hz) {
        if (leftOut != m_leftOut) {
            Q_EMIT changed();
        }
        return;
    }
    m_streamed = std::move(names);
    m_rate_Hz = rate_Hz;
    m_session.setLiveStream(m_streamed, m_rate_Hz);
    Q_EMIT changed();
}

} // namespace halbench::app
