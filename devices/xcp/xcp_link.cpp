#include "devices/xcp/xcp_link.h"

#include <fmt/format.h>

#include <algorithm>

namespace halbench::devices::xcp {

namespace {

constexpr double DefaultTimeout_s = 0.5;
/// A command with all its repetitions is given up after this time: nobody waits longer than 2 s for a dead
/// board. Two repetitions, as other programs have, lose the session on a line that loses one octet in a
/// hundred (resources/help/protocol.md, 3.6).
constexpr double MaxSilence_s = 1.8;
/// The end for a board that answers nonsense at once; where answers are missing, the time is.
constexpr int MaxRepeats = 16;
/// SYNCH has this at least, also behind the last try: trouble just before the end is no dead board yet.
constexpr double LeastSynch_s = 0.2;
constexpr double MaxDrain_s = 0.05;
constexpr int MaxWaits = 50;
constexpr double BusyWait_s = 0.02;
constexpr std::size_t RoundTripsKept = 1024;
/// How late an order of another thread may be noticed.
constexpr double OrderPeriod_s = 5e-3;
constexpr std::uint8_t StopSubCommand = 0x45; // "E"
constexpr double StopPeriod_s = 0.010;
constexpr int StopRepeats = 2;
constexpr const char* CableHint = "check cable, power and address, then connect again";

Trouble trouble(TroubleCause cause, ErrorCode code, std::string message, std::string hint = CableHint) {
    return {cause, 0, {code, std::move(message), std::move(hint)}};
}

/// A command that the line damaged is rejected like a wrong one: a line that has spoiled something is the
/// first suspect, one that has not is none.
std::string hintOfRefusal(std::uint64_t troublesSeen) {
    return troublesSeen == 0
               ? "check the value and the board's state"
               : fmt::format(
                     "the line has lost or damaged packets (so far {}): check the line, then the value "
                     "and the board's state",
                     troublesSeen);
}

} // namespace

bool isBusy(std::uint8_t slaveError) {
    const auto code = static_cast<SlaveError>(slaveError);
    return code == SlaveError::Busy || code == SlaveError::ProgrammingActive ||
           code == SlaveError::ResourceBusy;
}

XcpLink::XcpLink(std::unique_ptr<Transport> transport)
    : m_transport(std::move(transport)), m_timeout_s(DefaultTimeout_s) {}

Reply<bool> XcpLink::receive(double timeout_s) {
    if (m_lost) {
        return tl::unexpected(Trouble{TroubleCause::Lost, 0, *m_lost});
    }
    const Result<bool> received = m_transport->receive(m_packet, std::max(timeout_s, 0.0));
    if (!received) {
        markLost(received.error());
        return tl::unexpected(Trouble{TroubleCause::Lost, 0, *m_lost});
    }
    return *received;
}

/// What came in time is taken, though a busy computer looks late: only what the board did not send is its
/// silence. `until_s`: set by the first look, so that a flood of packets ends.
Reply<bool> XcpLink::lookLate(std::optional<double>& until_s) {
    const double now_s = m_transport->now_s();
    until_s = until_s.value_or(now_s + MaxDrain_s);
    return now_s > *until_s ? Reply<bool>(false) : receive(0.0);
}

double XcpLink::patience_s(double deadline_s) const {
    const double left_s = deadline_s - m_transport->now_s();
    return m_orders ? std::min(left_s, OrderPeriod_s) : left_s;
}

Result<void> XcpLink::sendStop() {
    m_stopsObeyed = m_orders ? m_orders->stops.load() : 0;
    m_isOutOfStep = true;
    ++m_stopsSent;
    m_stopSent_s = m_transport->now_s();
    return sendNow(CommandEncoder().userCommand(StopSubCommand));
}

/// Sends the stop that another thread asked for; true when there was one.
bool XcpLink::obeyStop() {
    if (!m_orders || m_orders->stops == m_stopsObeyed) {
        return false;
    }
    m_stopRepeats = StopRepeats;
    (void)sendStop(); // a link that is gone shows at the next receive
    return true;
}

std::optional<Trouble> XcpLink::obeyOrders() {
    if (m_isOpening && m_orders && m_orders->isLeaving) {
        markLost({ErrorCode::Interrupted,
                  fmt::format("{}: connection attempt ended", m_transport->description()), ""});
        return Trouble{TroubleCause::Lost, 0, *m_lost};
    }
    if (obeyStop()) {
        return trouble(TroubleCause::Overtaken, ErrorCode::Interrupted,
                       "a stop was sent before the device answered", "try again");
    }
    return std::nullopt;
}

Reply<Packet> XcpLink::exchange(const Packet& command, double patience_s) {
    if (std::optional<Trouble> overtaken = obeyOrders()) {
        return tl::unexpected(*std::move(overtaken));
    }
    const bool isConnecting = command[0] == static_cast<std::uint8_t>(Command::Connect);
    m_hasSession = m_hasSession && !isConnecting;
    if (m_isOutOfStep && !isConnecting) { // a board that is not connected does not answer SYNCH
        if (const Result<void> synchronised = synchronise(); !synchronised) {
            return tl::unexpected(Trouble{TroubleCause::Lost, 0, synchronised.error()});
        }
    }
    // Answers that nobody waits for any more must not be taken for the next command's.
    // Nor does a flood of packets hold a command up.
    const double drained_s = m_transport->now_s() + MaxDrain_s;
    while (m_transport->now_s() <= drained_s) {
        const Reply<bool> received = receive(0.0);
        if (!received) {
            return tl::unexpected(received.error());
        }
        if (std::optional<Trouble> overtaken = obeyOrders()) {
            return tl::unexpected(*std::move(overtaken));
        }
        if (!*received) {
            break;
        }
        dispatch();
    }
    const double start_s = m_transport->now_s();
    if (Result<void> sent = sendNow(command); !sent) {
        return tl::unexpected(Trouble{TroubleCause::Lost, 0, sent.error()});
    }
    Reply<Packet> reply = awaitAnswer(command[0], start_s + (patience_s > 0.0 ? patience_s : timeout_s()));
    if (reply) {
        m_hasSession = m_hasSession || isConnecting;
        m_lastExchange = {start_s, m_transport->now_s()};
        noteRoundTrip(m_lastExchange.answered_s - start_s);
    }
    return reply;
}

std::uint64_t XcpLink::troublesSeen() const {
    const TransportStatistics wire = m_transport->statistics();
    return wire.packetsDamaged + wire.packetsLost + m_repeated;
}

Reply<Packet> XcpLink::nextResponse(std::uint8_t command) {
    return awaitAnswer(command, m_transport->now_s() + timeout_s());
}

Reply<Packet> XcpLink::awaitAnswer(std::uint8_t command, double deadline_s) {
    const double start_s = m_transport->now_s();
    std::optional<double> lateUntil_s;
    m_isPending = false;
    for (;;) {
        if (std::optional<Trouble> overtaken = obeyOrders()) {
            return tl::unexpected(*std::move(overtaken));
        }
        const bool isOver = m_transport->now_s() >= deadline_s; // before the look: see lookLate()
        const Reply<bool> received = isOver ? lookLate(lateUntil_s) : receive(patience_s(deadline_s));
        if (!received) {
            return tl::unexpected(received.error());
        }
        if (!*received && isOver) {
            return tl::unexpected(trouble(
                TroubleCause::Timeout, ErrorCode::DeviceLost,
                fmt::format("{} does not answer {}", m_transport->description(), commandName(command))));
        }
        if (!*received) {
            continue;
        }
        const PacketKind kind = kindOf(m_packet);
        if (kind == PacketKind::Response) {
            return m_packet;
        }
        if (kind == PacketKind::Error) {
            const std::uint8_t code = m_packet.size() > 1 ? m_packet[1] : 0x31;
            // Only SYNCH is answered so: an older one, of a time when the board was held up.
            if (code == static_cast<std::uint8_t>(SlaveError::Synch)) {
                continue;
            }
            Trouble refused =
                trouble(TroubleCause::Slave, ErrorCode::DeviceRefused,
                        fmt::format("the device rejected {}: {}", commandName(command), slaveErrorText(code)),
                        hintOfRefusal(troublesSeen()));
            refused.slaveError = code;
            return tl::unexpected(std::move(refused));
        }
        dispatch();
        if (m_isPending) {
            m_isPending = false;
            deadline_s = std::min(m_transport->now_s() + timeout_s(), start_s + MaxSilence_s);
        }
    }
}

void XcpLink::dispatch() {
    switch (kindOf(m_packet)) {
    case PacketKind::Data:
        if (m_handlers.onData) {
            m_handlers.onData(m_packet);
        }
        break;
    case PacketKind::Event:
        handleEvent();
        break;
    case PacketKind::Service:
        if (m_handlers.onText && m_packet.size() > 2 && m_packet[1] == 0x01) {
            const auto end = std::find(m_packet.begin() + 2, m_packet.end(), std::uint8_t{0});
            m_handlers.onText(std::string(m_packet.begin() + 2, end));
        }
        break;
    case PacketKind::Response:
    case PacketKind::Error:
    case PacketKind::Empty:
        break; // an answer that nobody waits for any more
    }
}

void XcpLink::handleEvent() {
    if (m_packet.size() < 2) {
        return;
    }
    const std::uint8_t code = m_packet[1];
    if (code == static_cast<std::uint8_t>(Event::CommandPending)) {
        m_isPending = true;
    }
    if (m_handlers.onEvent) {
        m_handlers.onEvent(code, m_packet);
    }
    // What comes before a session begins was said of an earlier one.
    if (code == static_cast<std::uint8_t>(Event::SessionTerminated) && m_hasSession) {
        markLost({ErrorCode::DeviceLost,
                  fmt::format("{} ended the session (watchdog timeout, or another program connected)",
                              m_transport->description()),
                  "make sure that no other program uses the device, then connect again"});
    }
}

Result<bool> XcpLink::pumpOnce(double timeout_s) {
    (void)obeyStop(); // whoever waits here has nothing outstanding: it goes out at once
    const Reply<bool> received = receive(timeout_s);
    if (!received) {
        return failure(received.error().error);
    }
    if (*received) {
        dispatch();
    }
    return *received;
}

Result<bool> XcpLink::pumpUntilAnswer(double timeout_s) {
    const double deadline_s = m_transport->now_s() + timeout_s;
    while (m_transport->now_s() < deadline_s) {
        const Reply<bool> received = receive(deadline_s - m_transport->now_s());
        if (!received) {
            return failure(received.error().error);
        }
        if (!*received) {
            continue;
        }
        const PacketKind kind = kindOf(m_packet);
        if (kind == PacketKind::Response || kind == PacketKind::Error) {
            return true;
        }
        dispatch();
    }
    return false;
}

Result<void> XcpLink::pumpUntil(double time_s) {
    while (m_transport->now_s() < time_s) {
        if (const Result<bool> pumped = pumpOnce(time_s - m_transport->now_s()); !pumped) {
            return failure(pumped.error());
        }
    }
    return {};
}

Result<void> XcpLink::sendNow(const Packet& command) {
    if (m_lost) {
        return failure(*m_lost);
    }
    Result<void> sent = m_transport->send(command);
    if (!sent) {
        markLost(sent.error());
    }
    return sent;
}

Result<void> XcpLink::synchronise() {
    return synchronise(m_transport->now_s() + MaxSilence_s);
}

Result<void> XcpLink::synchronise(double deadline_s) {
    const Packet command = CommandEncoder().plain(Command::Synch);
    while (m_transport->now_s() < deadline_s) {
        if (Result<void> sent = sendNow(command); !sent) {
            return sent;
        }
        const Result<bool> synchronised =
            awaitSynchronised(std::min(m_transport->now_s() + timeout_s(), deadline_s));
        if (!synchronised) {
            return failure(synchronised.error());
        }
        if (*synchronised) {
            m_isOutOfStep = false;
            return {};
        }
    }
    markLost(
        {ErrorCode::DeviceLost, fmt::format("{} stopped responding", m_transport->description()), CableHint});
    return failure(*m_lost);
}

/// Discards what arrives until SYNCH is answered. A stop that is sent meanwhile takes a SYNCH of its own
/// along, so that its answer is discarded as well.
Result<bool> XcpLink::awaitSynchronised(double deadline_s) {
    const Packet command = CommandEncoder().plain(Command::Synch);
    int sent = 1;
    int answered = 0;
    std::optional<double> lateUntil_s;
    while (answered < sent) {
        const bool isOver = m_transport->now_s() >= deadline_s;
        const bool isDue = m_stopRepeats > 0 && m_transport->now_s() >= m_stopSent_s + StopPeriod_s;
        if (obeyStop() || (isDue && m_stopRepeats-- > 0 && sendStop())) {
            (void)sendNow(command); // a link that is gone shows in receive()
            ++sent;
        }
        const Reply<bool> received = isOver ? lookLate(lateUntil_s) : receive(patience_s(deadline_s));
        if (!received) {
            return failure(received.error().error);
        }
        if (!*received && isOver) {
            break;
        }
        if (!*received) {
            continue;
        }
        if (kindOf(m_packet) == PacketKind::Error && m_packet.size() > 1 && m_packet[1] == 0x00) {
            ++answered;
        } else {
            dispatch();
        }
    }
    m_stopRepeats = 0;
    return answered > 0;
}

std::optional<Error> XcpLink::afterTrouble(const Trouble& trouble, int& repeats, int& waits, double start_s) {
    const double elapsed_s = m_transport->now_s() - start_s;
    if (trouble.cause == TroubleCause::Lost) {
        return trouble.error;
    }
    if (trouble.cause == TroubleCause::Overtaken) {
        return elapsed_s < MaxSilence_s ? std::nullopt : std::optional<Error>(trouble.error);
    }
    if (trouble.cause == TroubleCause::Slave) {
        const auto code = static_cast<SlaveError>(trouble.slaveError);
        if (isBusy(trouble.slaveError) && waits < MaxWaits && elapsed_s < MaxSilence_s) {
            ++waits;
            const Result<void> waited = pumpUntil(m_transport->now_s() + BusyWait_s);
            return waited ? std::nullopt : std::optional<Error>(waited.error());
        }
        // Out of order after a repetition: once more from the start.
        if (code != SlaveError::Sequence || repeats > 0) {
            return trouble.error;
        }
    }
    const bool isUnanswered = trouble.cause == TroubleCause::Timeout;
    if (elapsed_s >= MaxSilence_s || (repeats >= MaxRepeats && !isUnanswered)) {
        if (isUnanswered) {
            markLost(trouble.error);
        }
        return trouble.error;
    }
    ++repeats;
    ++m_repeated;
    const Result<void> synchronised =
        synchronise(std::max(start_s + MaxSilence_s, m_transport->now_s() + LeastSynch_s));
    return synchronised ? std::nullopt : std::optional<Error>(synchronised.error());
}

void XcpLink::markLost(Error error) {
    if (!m_lost) {
        m_lost = std::move(error);
    }
}

void XcpLink::noteRoundTrip(double duration_s) {
    m_worstRoundTrip_s = std::max(m_worstRoundTrip_s, duration_s);
    m_roundTrips_s.push_back(duration_s);
    if (m_roundTrips_s.size() > RoundTripsKept) {
        m_roundTrips_s.pop_front();
    }
    // Here, at each command; it is asked for with each packet of a stream.
    std::vector<double> sorted(m_roundTrips_s.begin(), m_roundTrips_s.end());
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    m_medianRoundTrip_s = *middle;
}

} // namespace halbench::devices::xcp
