#pragma once

#include "control/base/result.h"
#include "devices/link_orders.h"
#include "devices/transport/transport.h"
#include "devices/xcp/packets.h"

#include <algorithm>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace halbench::devices::xcp {

/// Why one try of a command gave no answer that can be used.
enum class TroubleCause {
    Overtaken, ///< a stop was sent meanwhile; SYNCH and repeat
    Timeout,   ///< nothing came; SYNCH and repeat
    BadAnswer, ///< an answer that does not fit the command; SYNCH and repeat
    Slave,     ///< the board answered with an error code
    Lost       ///< the link is gone; nothing helps
};

struct Trouble {
    TroubleCause cause = TroubleCause::Lost;
    std::uint8_t slaveError = 0;
    Error error;
};

template <typename T = void>
using Reply = tl::expected<T, Trouble>;

inline tl::unexpected<Trouble> badAnswer(Error error) {
    return tl::unexpected(Trouble{TroubleCause::BadAnswer, 0, std::move(error)});
}
/// The board asks to be asked again later.
bool isBusy(std::uint8_t slaveError);
/// The board has answered, and the answer is no.
inline bool isRefused(const Trouble& trouble) {
    return trouble.cause == TroubleCause::Slave && !isBusy(trouble.slaveError);
}

/// Receivers of what the board sends by itself; each may be empty. They must not use the link.
struct LinkHandlers {
    std::function<void(Octets)> onData;
    std::function<void(std::uint8_t code, Octets packet)> onEvent;
    std::function<void(const std::string&)> onText;
};

/// One command at a time over one transport, with time-out, SYNCH and repetition (3.6); takes in samples,
/// events and texts whenever they arrive. Thread: the connection's.
class XcpLink {
public:
    explicit XcpLink(std::unique_ptr<Transport> transport);

    Transport& transport() { return *m_transport; }
    const Transport& transport() const { return *m_transport; }
    void setHandlers(LinkHandlers handlers) { m_handlers = std::move(handlers); }
    void setAnswerTimeout(double timeout_s) { m_timeout_s = timeout_s; }
    /// Waits no longer than this for an answer, whatever the board asks for: several lost in a row must not
    /// let its watchdog run out. Nothing: as set.
    void limitAnswerTimeout(std::optional<double> limit_s) { m_timeoutLimit_s = limit_s; }
    /// What other threads want, looked at while an answer is awaited and with each packet; may be empty.
    /// Stops that were asked for before concern the link before this one.
    void setOrders(std::shared_ptr<const LinkOrders> orders) {
        m_orders = std::move(orders);
        m_stopsObeyed = m_orders ? m_orders->stops.load() : 0;
    }
    /// The board is open: from now on LinkOrders::isLeaving is the caller's to obey.
    void noteOpened() { m_isOpening = false; }

    /// One try: sends, waits, gives the whole RES packet. `patience_s` 0 = the usual one.
    Reply<Packet> exchange(const Packet& command, double patience_s = 0.0);
    /// The next RES of a block answer, without sending.
    Reply<Packet> nextResponse(std::uint8_t command);

    /// Runs a step of one or more commands until it succeeds: repeats it from its start after SYNCH when an
    /// answer is missing or makes no sense, waits when the board is busy. The step must be repeatable as a
    /// whole (3.6).
    template <typename Step>
    auto recover(Step step) -> Result<typename decltype(step())::value_type>;

    /// Takes in whatever arrives until the time is reached.
    Result<void> pumpUntil(double time_s);
    /// Takes in at most one packet within the time; false when none came.
    Result<bool> pumpOnce(double timeout_s);

    /// Sends the emergency stop without waiting and whatever is outstanding (3.11). Its answer cannot be told
    /// from that of another command, so the next exchange() clears the queue by SYNCH first.
    Result<void> sendStop();
    /// Takes in packets until an answer of any kind comes; false when none came within the time.
    Result<bool> pumpUntilAnswer(double timeout_s);
    std::uint64_t stopsSent() const { return m_stopsSent; }
    /// Clears the board's command queue and everything that was on its way. Errors: DeviceLost.
    Result<void> synchronise();

    /// From now on every call fails with this error. The first one stays.
    void markLost(Error error);
    const std::optional<Error>& lost() const { return m_lost; }

    std::uint64_t repeatedCommands() const { return m_repeated; }
    /// When the last command that was answered was sent, and when its answer came.
    struct Exchange {
        double sent_s = 0.0;
        double answered_s = 0.0;
    };
    const Exchange& lastExchange() const { return m_lastExchange; }
    double roundTripMedian_s() const { return m_medianRoundTrip_s; }
    double roundTripWorst_s() const { return m_worstRoundTrip_s; }

private:
    /// Packets that were damaged or lost, and commands that were repeated, since the link was opened.
    std::uint64_t troublesSeen() const;
    Reply<Packet> awaitAnswer(std::uint8_t command, double deadline_s);
    Reply<bool> receive(double timeout_s);
    Reply<bool> lookLate(std::optional<double>& until_s);
    Result<void> sendNow(const Packet& command);
    bool obeyStop();
    std::optional<Trouble> obeyOrders();
    Result<void> synchronise(double deadline_s);
    Result<bool> awaitSynchronised(double deadline_s);
    /// Longest time until the orders are looked at again.
    double patience_s(double deadline_s) const;
    void dispatch();
    void handleEvent();
    void noteRoundTrip(double duration_s);
    /// Decides what follows a failed try: nothing = repeat.
    std::optional<Error> afterTrouble(const Trouble& trouble, int& repeats, int& waits, double start_s);

    std::unique_ptr<Transport> m_transport;
    LinkHandlers m_handlers;
    double timeout_s() const { return std::min(m_timeout_s, m_timeoutLimit_s.value_or(m_timeout_s)); }

    double m_timeout_s;
    std::optional<double> m_timeoutLimit_s;
    Packet m_packet; ///< storage reused by every receive
    std::optional<Error> m_lost;
    bool m_isPending = false; ///< the board asked for more time
    std::shared_ptr<const LinkOrders> m_orders;
    bool m_isOpening = true;
    bool m_hasSession = false;       ///< CONNECT was answered
    std::uint64_t m_stopsObeyed = 0; ///< of the orders
    std::uint64_t m_stopsSent = 0;
    double m_stopSent_s = 0.0;
    int m_stopRepeats = 0;      ///< still to be sent while SYNCH is not answered
    bool m_isOutOfStep = false; ///< the answer of a stop is on its way
    std::uint64_t m_repeated = 0;
    Exchange m_lastExchange;
    std::deque<double> m_roundTrips_s;
    double m_medianRoundTrip_s = 0.0;
    double m_worstRoundTrip_s = 0.0;
};

template <typename Step>
auto XcpLink::recover(Step step) -> Result<typename decltype(step())::value_type> {
    int repeats = 0;
    int waits = 0;
    const double start_s = m_transport->now_s();
    for (;;) {
        auto reply = step();
        if (reply) {
            if constexpr (std::is_void_v<typename decltype(step())::value_type>) {
                return {};
            } else {
                return *std::move(reply);
            }
        }
        if (const std::optional<Error> error = afterTrouble(reply.error(), repeats, waits, start_s)) {
            return failure(*error);
        }
    }
}

} // namespace halbench::devices::xcp
