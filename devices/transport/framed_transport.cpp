#include "devices/transport/framed_transport.h"

#include "control/base/assert.h"

#include <fmt/format.h>

#include <algorithm>

namespace halbench::devices {

namespace {

/// CONNECT is tried so often in the first framing before others get their turn: a board that is reset by the
/// opening of its port needs up to 2 s (resources/help/protocol.md 3.6).
constexpr std::size_t FirstTries = 5;
/// Without framing, octets further apart than this do not belong together: 16 ms of a USB adapter's patience
/// and some of this system's.
constexpr double InterOctetTimeout_s = 0.05;

} // namespace

FramedTransport::FramedTransport(std::unique_ptr<OctetPort> port, Codecs codecs, double connectPatience_s)
    : m_port(std::move(port)), m_codecs(std::move(codecs)), m_connectPatience_s(connectPatience_s),
      m_start(std::chrono::steady_clock::now()) {
    HB_ASSERT(!m_codecs.empty());
}

double FramedTransport::now_s() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
}

Result<void> FramedTransport::open() {
    close();
    m_inbox.clear();
    m_unanswered = 0;
    selectCodec(0);
    Result<void> opened = m_port->open(m_inbox);
    m_isOpen = opened.has_value();
    return opened;
}

void FramedTransport::close() noexcept {
    if (m_isOpen) {
        m_isOpen = false;
        m_port->close();
    }
}

Error FramedTransport::lost(Error error) {
    close();
    return error;
}

void FramedTransport::selectCodec(std::size_t index) {
    m_current = index;
    codec().restart();
    m_lastCounter.reset();
}

void FramedTransport::noteUnansweredConnect() {
    ++m_unanswered;
    if (m_codecs.size() > 1) {
        const std::size_t cycle = m_unanswered % (FirstTries + m_codecs.size() - 1);
        selectCodec(cycle < FirstTries ? 0 : cycle - FirstTries + 1);
    }
}

Result<void> FramedTransport::send(std::span<const std::uint8_t> packet) {
    if (!m_isOpen) {
        return failure(notOpen());
    }
    m_outgoing.clear();
    codec().append(m_outgoing, m_sendCounter++, packet);
    if (Result<void> written = m_port->write(m_outgoing); !written) {
        return failure(lost(written.error()));
    }
    ++m_statistics.packetsSent;
    return {};
}

void FramedTransport::followCounter(const Frame& frame) {
    const std::uint16_t mask = codec().counterMask();
    if (!frame.counter || mask == 0) {
        return;
    }
    if (m_lastCounter) {
        const auto missing = static_cast<std::uint16_t>((*frame.counter - *m_lastCounter - 1) & mask);
        // Further ahead than half a turn is a step back: the board counts anew, or a frame came twice.
        m_statistics.packetsLost += missing <= mask / 2 ? missing : 0;
    }
    m_lastCounter = frame.counter;
}

Result<bool> FramedTransport::takeFrame(std::vector<std::uint8_t>& packet) {
    const Result<std::optional<Frame>> frame = codec().next();
    if (!frame) {
        return failure(lost({frame.error().code, fmt::format("{}: {}", description(), frame.error().message),
                             frame.error().hint}));
    }
    if (!*frame) {
        return false;
    }
    followCounter(**frame);
    ++m_statistics.packetsReceived;
    packet.assign((*frame)->packet.begin(), (*frame)->packet.end());
    return true;
}

Result<bool> FramedTransport::receive(std::vector<std::uint8_t>& packet, double timeout_s) {
    const double deadline_s = now_s() + timeout_s;
    for (bool hasLooked = false;; hasLooked = true) {
        Result<bool> taken = takeFrame(packet);
        const double left_s = deadline_s - now_s();
        // A line full of octets that are no frames does not hold anybody up.
        if (!taken || *taken || (hasLooked && left_s <= 0.0)) {
            return taken;
        }
        if (!m_isOpen) {
            return failure(notOpen());
        }
        const Result<bool> arrived = m_inbox.take(m_incoming, left_s);
        if (!arrived) {
            return failure(lost(arrived.error()));
        }
        if (*arrived) {
            takeOctets();
        }
    }
}

void FramedTransport::takeOctets() {
    if (now_s() - m_lastOctet_s > InterOctetTimeout_s) {
        codec().noteSilence();
    }
    m_lastOctet_s = now_s();
    codec().feed(m_incoming);
}

Error FramedTransport::notOpen() const {
    return {ErrorCode::DeviceLost, fmt::format("{} is not open", description()), "connect again"};
}

TransportStatistics FramedTransport::statistics() const {
    TransportStatistics statistics = m_statistics;
    for (const auto& known : m_codecs) {
        statistics.packetsDamaged += known->damaged();
    }
    statistics.octetsReceived = m_inbox.received();
    return statistics;
}

} // namespace halbench::devices
