#include "tests/devices/firmware/mps2/emulator/mps2_transport.h"

#include "devices/open/sxi_framing.h"

#include <algorithm>

namespace halbench::mps2 {
namespace {

Error closedError() {
    return {ErrorCode::DeviceLost, "the line to the emulated board is closed", "Open the device again."};
}

} // namespace

Result<void> Mps2Transport::open() {
    m_now_s = m_board->time_s();
    hb_sxi_receiver_init(&m_receiver);
    (void)m_board->take(); // meant for another
    m_octets.clear();
    m_next = 0;
    m_statistics = {};
    m_hasCounter = false;
    m_isOpen = true;
    return {};
}

Result<void> Mps2Transport::send(std::span<const std::uint8_t> packet) {
    if (!m_isOpen) {
        return failure(closedError());
    }
    std::vector<std::uint8_t> line;
    devices::SxiFraming().append(line, m_sent++, packet);
    ++m_statistics.packetsSent;
    return m_board->send(line);
}

void Mps2Transport::countMessage(std::uint8_t counter) {
    if (m_hasCounter) {
        m_statistics.packetsLost += static_cast<std::uint8_t>(counter - m_lastCounter - 1);
    }
    m_lastCounter = counter;
    m_hasCounter = true;
    ++m_statistics.packetsReceived;
}

bool Mps2Transport::takePacket(std::vector<std::uint8_t>& packet) {
    if (m_next == m_octets.size()) {
        m_octets = m_board->take();
        m_next = 0;
    }
    while (m_next < m_octets.size()) {
        const std::uint16_t length = hb_sxi_receive(&m_receiver, m_octets[m_next++]);
        if (length > 0) {
            const std::uint8_t* start = hb_sxi_packet(&m_receiver);
            packet.assign(start, start + length);
            countMessage(start[-1]);
            return true;
        }
    }
    return false;
}

Result<bool> Mps2Transport::receive(std::vector<std::uint8_t>& packet, double timeout_s) {
    if (!m_isOpen) {
        return failure(closedError());
    }
    if (takePacket(packet)) {
        return true;
    }
    const double deadline_s = m_now_s + std::max(timeout_s, 0.0);
    constexpr double Rounding_s = 1e-9;
    while (m_board->time_s() + Mps2Board::Tick_s <= deadline_s + Rounding_s) {
        if (auto ticked = m_board->tick(); !ticked) {
            return failure(ticked.error());
        }
        m_now_s = std::max(m_now_s, m_board->time_s());
        if (takePacket(packet)) {
            return true;
        }
    }
    m_now_s = std::max(m_now_s, deadline_s);
    return false;
}

} // namespace halbench::mps2
