#include "devices/simulated/loopback_transport.h"

#include <algorithm>
#include <thread>

namespace halbench::devices {
namespace {

Error closedError() {
    return {ErrorCode::DeviceLost, "the loopback to the simulated board is closed", "Open the device again."};
}

} // namespace

LoopbackTransport::LoopbackTransport(std::shared_ptr<SimulatedBoard> board, bool isRealtime)
    : m_board(std::move(board)), m_isRealtime(isRealtime) {}

Result<void> LoopbackTransport::open() {
    m_now_s = m_board->time_s();
    m_start =
        std::chrono::steady_clock::now() - std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                               std::chrono::duration<double>(m_now_s));
    m_isOpen = true;
    std::vector<std::uint8_t> meantForAnother;
    while (takePacket(meantForAnother)) {
    }
    m_statistics = {};
    return {};
}

void LoopbackTransport::close() noexcept {
    m_isOpen = false;
}

Result<void> LoopbackTransport::send(std::span<const std::uint8_t> packet) {
    if (!m_isOpen) {
        return failure(closedError());
    }
    catchUp();
    m_board->receive(packet);
    ++m_statistics.packetsSent;
    return {};
}

void LoopbackTransport::countMessage() {
    const std::uint16_t counter = m_board->messageCounter();
    if (m_hasCounter) {
        m_statistics.packetsLost += static_cast<std::uint16_t>(counter - m_lastCounter - 1U);
    }
    m_lastCounter = counter;
    m_hasCounter = true;
    ++m_statistics.packetsReceived;
}

bool LoopbackTransport::takePacket(std::vector<std::uint8_t>& packet) {
    packet.resize(HB_MAX_DTO);
    const std::size_t octets = m_board->transmit(packet);
    packet.resize(octets);
    if (octets > 0) {
        countMessage();
    }
    return octets > 0;
}

void LoopbackTransport::catchUp() {
    if (m_isRealtime) {
        const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - m_start;
        m_board->advanceTo(wall.count());
        m_now_s = std::max(m_now_s, m_board->time_s());
    }
}

void LoopbackTransport::waitForWallClock() {
    if (m_isRealtime) {
        std::this_thread::sleep_until(
            m_start + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                          std::chrono::duration<double>(m_board->time_s() + SimulatedBoard::Tick_s)));
    }
}

Result<bool> LoopbackTransport::receive(std::vector<std::uint8_t>& packet, double timeout_s) {
    if (!m_isOpen) {
        return failure(closedError());
    }
    catchUp();
    if (takePacket(packet)) {
        return true;
    }
    const double deadline_s = m_now_s + std::max(timeout_s, 0.0);
    constexpr double Rounding_s = 1e-9;
    while (m_board->time_s() + SimulatedBoard::Tick_s <= deadline_s + Rounding_s) {
        waitForWallClock();
        m_board->tick();
        m_now_s = std::max(m_now_s, m_board->time_s());
        if (takePacket(packet)) {
            return true;
        }
    }
    m_now_s = std::max(m_now_s, deadline_s);
    return false;
}

} // namespace halbench::devices
