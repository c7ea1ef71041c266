#pragma once

#include "devices/simulated/registry/simulated_device.h"
#include "devices/transport/board_server.h"

namespace halbench::devices {

/// A simulated board as a server sees any board. The board must outlive it.
class ServedSimulation : public ServedBoard {
public:
    explicit ServedSimulation(SimulatedBoard& board) : m_board(&board) {}

    void advanceTo(double time_s) override { m_board->advanceTo(time_s); }
    void receive(std::span<const std::uint8_t> packet) override { m_board->receive(packet); }
    bool transmit(std::vector<std::uint8_t>& packet, std::uint16_t& counter) override {
        packet.resize(HB_MAX_DTO);
        packet.resize(m_board->transmit(packet));
        counter = m_board->messageCounter();
        return !packet.empty();
    }

private:
    SimulatedBoard* m_board;
};

} // namespace halbench::devices
