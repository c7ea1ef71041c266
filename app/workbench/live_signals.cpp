#include "app/workbench/live_signals.h"

#include "devices/acquisition/stream_rate.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

namespace halbench::app {

namespace {

constexpr double UsualRate_Hz = 1000.0; ///< unless somebody needs more
/// 15 signals of 4 octets at 115200 Bd leave room for 167 rows a second (resources/help/protocol.md 3.14).
constexpr double SerialRate_Hz = 100.0;

/// A whole part of the rate that all of them have.
double usualRateOf(const devices::DeviceInfo& info, const std::vector<const SignalSpec*>& specs) {
    const double most_Hz = info.transport == "serial" ? SerialRate_Hz : UsualRate_Hz;
    double common_Hz = specs.empty() ? most_Hz : specs.front()->maxRate_Hz;
    for (const SignalSpec* spec : specs) {
        common_Hz = std::min(common_Hz, spec->maxRate_Hz);
    }
    return common_Hz / std::max(1.0, std::ceil(common_Hz / most_Hz));
}

/// The slowest of these parts that is no slower than what is needed.
double partFor_Hz(const std::vector<const SignalSpec*>& specs, double needed_Hz) {
    constexpr double Rounding = 1e-9;
    double common_Hz = specs.front()->maxRate_Hz;
    for (const SignalSpec* spec : specs) {
        common_Hz = std::min(common_Hz, spec->maxRate_Hz);
    }
    return common_Hz / std::max(1.0, std::floor(common_Hz / needed_Hz * (1.0 + Rounding)));
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
    know(client);
    m_wanted[client] = std::move(names);
    restart();
}

void LiveSignals::wantRate(const QObject* client, double rate_Hz) {
    know(client);
    m_rates_Hz[client] = rate_Hz;
    restart();
}

void LiveSignals::know(const QObject* client) {
    if (m_wanted.count(client) > 0 || m_rates_Hz.count(client) > 0) {
        return;
    }
    connect(client, &QObject::destroyed, this, [this, client] {
        m_wanted.erase(client);
        m_rates_Hz.erase(client);
        // Later: who listens may be what is being destroyed just now.
        QMetaObject::invokeMethod(
            this, [this] { restart(); }, Qt::QueuedConnection);
    });
}

double LiveSignals::greatestRate_Hz(const std::vector<std::string>& more) const {
    std::vector<std::string> names = m_streamed;
    std::copy_if(more.begin(), more.end(), std::back_inserter(names), [this](const std::string& name) {
        return std::find(m_streamed.begin(), m_streamed.end(), name) == m_streamed.end();
    });
    return devices::greatestRate_Hz(m_session.info(), m_session.catalogue(), names);
}

/// As usual, or as somebody needs it and it can be.
double LiveSignals::rateFor(const std::vector<const SignalSpec*>& specs,
                            const std::vector<std::string>& names) const {
    const double usual_Hz = usualRateOf(m_session.info(), specs);
    double needed_Hz = 0.0;
    for (const auto& [client, rate_Hz] : m_rates_Hz) {
        needed_Hz = std::max(needed_Hz, rate_Hz);
    }
    if (specs.empty() || needed_Hz <= usual_Hz) {
        return usual_Hz;
    }
    const double most_Hz = devices::greatestRate_Hz(m_session.info(), m_session.catalogue(), names);
    return std::max(usual_Hz, std::min(partFor_Hz(specs, needed_Hz), most_Hz));
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

void LiveSignals::setHeld(bool isHeld) {
    if (std::exchange(m_isHeld, isHeld) && !isHeld) {
        restart();
    }
}

void LiveSignals::postpone(const std::vector<std::string>& names) {
    std::vector<std::string> missing;
    std::copy_if(names.begin(), names.end(), std::back_inserter(missing), [this](const std::string& name) {
        return std::find(m_streamed.begin(), m_streamed.end(), name) == m_streamed.end();
    });
    if (missing != m_postponed) {
        m_postponed = std::move(missing);
        Q_EMIT changed();
    }
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
    std::vector<std::string> apart = takeOut(specs);
    std::vector<std::string> names;
    for (const SignalSpec* spec : specs) {
        names.push_back(spec->name);
    }
    if (m_isHeld && !m_streamed.empty()) {
        postpone(names);
        return;
    }
    const bool wasWaiting = !std::exchange(m_postponed, {}).empty();
    const bool isSaid = std::exchange(m_leftOut, std::move(apart)) != m_leftOut || wasWaiting;
    m_usual_Hz = usualRateOf(m_session.info(), specs);
    const double rate_Hz = rateFor(specs, names);
    if (names == m_streamed && rate_Hz == m_rate_Hz) {
        if (isSaid) {
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
