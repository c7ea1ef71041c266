#pragma once

#include "devices/firmware/xcp/hb_sxi.h"
#include "devices/transport/transport.h"
#include "tests/devices/firmware/mps2/emulator/mps2_board.h"

#include <memory>

namespace halbench::mps2 {

/// The serial line between a master in this process and the board, in the board's time: packets arrive at
/// once, time passes only inside receive(), as on the loopback of the simulated board. HB-SxI like the real
/// line (resources/help/protocol.md 3.3.3).
class Mps2Transport : public devices::Transport {
public:
    explicit Mps2Transport(std::shared_ptr<Mps2Board> board) : m_board(std::move(board)) {}

    Result<void> open() override;
    void close() noexcept override { m_isOpen = false; }
    Result<void> send(std::span<const std::uint8_t> packet) override;
    Result<bool> receive(std::vector<std::uint8_t>& packet, double timeout_s) override;
    double now_s() const override { return m_now_s; }
    devices::TransportStatistics statistics() const override { return m_statistics; }
    std::string description() const override { return "mps2"; }

private:
    bool takePacket(std::vector<std::uint8_t>& packet);
    void countMessage(std::uint8_t counter);

    std::shared_ptr<Mps2Board> m_board;
    devices::TransportStatistics m_statistics;
    hb_sxi_receiver m_receiver{};
    std::vector<std::uint8_t> m_octets;
    std::size_t m_next = 0;
    double m_now_s = 0.0;
    std::uint8_t m_sent = 0;
    std::uint8_t m_lastCounter = 0;
    bool m_hasCounter = false;
    bool m_isOpen = false;
};

} // namespace halbench::mps2
