#pragma once

#include "devices/open/sxi_framing.h"
#include "devices/transport/transport.h"
#include "tests/devices/firmware/avr/simavr/avr_board.h"

#include <memory>

namespace halbench::simavr {

/// The serial line between a master in this process and the board, in virtual time: receive() lets the board
/// run, nothing else does. HB-SxI like the real line (resources/help/protocol.md 3.3.3).
class AvrTransport : public devices::Transport {
public:
    explicit AvrTransport(std::shared_ptr<AvrBoard> board) : m_board(std::move(board)) {}

    /// Opening the port resets the board, as the DTR line of an Arduino does.
    Result<void> open() override;
    void close() noexcept override { m_isOpen = false; }
    Result<void> send(std::span<const std::uint8_t> packet) override;
    Result<bool> receive(std::vector<std::uint8_t>& packet, double timeout_s) override;
    double now_s() const override { return m_now_s; }
    devices::TransportStatistics statistics() const override { return m_statistics; }
    std::string description() const override { return "simavr"; }

private:
    void takeOctets();
    bool takePacket(std::vector<std::uint8_t>& packet);

    std::shared_ptr<AvrBoard> m_board;
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

} // namespace halbench::simavr
