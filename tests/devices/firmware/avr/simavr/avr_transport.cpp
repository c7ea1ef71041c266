#include "tests/devices/firmware/avr/simavr/avr_transport.h"

#include <algorithm>

namespace halbench::simavr {
namespace {

constexpr double Slice_s = 200e-6; // how much later than it was complete a packet may be seen

} // namespace

Result<void> AvrTransport::open() {
    m_board->core().reset();
    hb_sxi_receiver_init(&m_receiver);
    m_octets.clear();
    m_next = 0;
    m_statistics = {};
    m_hasCounter = false;
    m_now_s = m_board->time_s();
    m_isOpen = true;
    return {};
}

Result<void> AvrTransport::send(std::span<const std::uint8_t> packet) {
    if (!m_isOpen || !m_board->core().isRunning()) {
        return failure(ErrorCode::DeviceLost, "the device does not run", "Open it again.");
    }
    std::vector<std::uint8_t> line;
    devices::SxiFraming().append(line, m_sent++, packet);
    m_board->core().send(line);
    ++m_statistics.packetsSent;
    return {};
}

void AvrTransport::takeOctets() {
    if (m_next == m_octets.size()) {
        m_octets = m_board->core().take();
        m_next = 0;
    }
}

bool AvrTransport::takePacket(std::vector<std::uint8_t>& packet) {
    takeOctets();
    while (m_next < m_octets.size()) {
        const std::uint16_t length = hb_sxi_receive(&m_receiver, m_octets[m_next++]);
        if (length == 0) {
            continue;
        }
        const std::uint8_t* start = hb_sxi_packet(&m_receiver);
        packet.assign(start, start + length);
        const std::uint8_t counter = start[-1];
        if (m_hasCounter) {
            m_statistics.packetsLost += static_cast<std::uint8_t>(counter - m_lastCounter - 1);
        }
        m_lastCounter = counter;
        m_hasCounter = true;
        ++m_statistics.packetsReceived;
        return true;
    }
    return false;
}

Result<bool> AvrTransport::receive(std::vector<std::uint8_t>& packet, double timeout_s) {
    if (!m_isOpen || !m_board->core().isRunning()) {
        return failure(ErrorCode::DeviceLost, "the device does not run", "Open it again.");
    }
    const double deadline_s = m_now_s + std::max(timeout_s, 0.0);
    while (!takePacket(packet)) {
        if (m_now_s >= deadline_s) {
            return false;
        }
        m_now_s = std::min(m_now_s + Slice_s, deadline_s);
        m_board->advanceTo(m_now_s);
    }
    return true;
}

} // namespace halbench::simavr
