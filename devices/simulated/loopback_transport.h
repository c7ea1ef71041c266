#pragma once

#include "devices/simulated/simulated_board.h"
#include "devices/transport/transport.h"

#include <chrono>
#include <memory>

namespace halbench::devices {

/// The link to an embedded board: packets arrive at once, time passes only inside receive(). Paced by the
/// wall clock on request: receive() then waits until the host's clock has reached the board's, and board time
/// that the host spent elsewhere is caught up, so that a slow host meets the same watchdog as on hardware.
/// Thread: one, the connection's.
class LoopbackTransport : public Transport {
public:
    LoopbackTransport(std::shared_ptr<SimulatedBoard> board, bool isRealtime);

    Result<void> open() override;
    void close() noexcept override;
    Result<void> send(std::span<const std::uint8_t> packet) override;
    Result<bool> receive(std::vector<std::uint8_t>& packet, double timeout_s) override;
    double now_s() const override { return m_now_s; }
    TransportStatistics statistics() const override { return m_statistics; }
    std::string description() const override { return "loopback"; }

private:
    bool takePacket(std::vector<std::uint8_t>& packet);
    void countMessage();
    void catchUp();
    void waitForWallClock();

    std::shared_ptr<SimulatedBoard> m_board;
    TransportStatistics m_statistics;
    double m_now_s = 0.0;
    std::chrono::steady_clock::time_point m_start;
    std::uint16_t m_lastCounter = 0;
    bool m_hasCounter = false;
    bool m_isRealtime;
    bool m_isOpen = false;
};

} // namespace halbench::devices
