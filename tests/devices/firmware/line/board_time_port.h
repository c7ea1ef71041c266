#pragma once

#include "devices/transport/transport.h"
#include "tests/devices/firmware/line/board_line.h"

namespace halbench::firmware {

/// The program's serial port with the board's time for its own: a machine that is too slow for the board
/// makes both slow, and no answer comes too late by that.
class BoardTimePort : public devices::Transport {
public:
    BoardTimePort(std::unique_ptr<devices::Transport> port, const BoardLine& line)
        : m_port(std::move(port)), m_line(line) {}

    Result<void> open() override { return m_port->open(); }
    void close() noexcept override { m_port->close(); }
    Result<void> send(std::span<const std::uint8_t> packet) override { return m_port->send(packet); }
    Result<bool> receive(std::vector<std::uint8_t>& packet, double timeout_s) override {
        constexpr double Look_s = 1e-3;
        const double end_s = now_s() + timeout_s;
        for (;;) {
            const bool isOver = now_s() >= end_s; // before the look, so that what came in time is seen
            Result<bool> received = m_port->receive(packet, isOver ? 0.0 : Look_s);
            if (!received || *received || isOver) {
                return received;
            }
        }
    }
    double now_s() const override { return m_line.boardTime_s(); }
    devices::TransportStatistics statistics() const override { return m_port->statistics(); }
    std::string description() const override { return m_port->description(); }
    double connectPatience_s() const override { return m_port->connectPatience_s(); }
    void noteUnansweredConnect() override { m_port->noteUnansweredConnect(); }

private:
    std::unique_ptr<devices::Transport> m_port;
    const BoardLine& m_line;
};

} // namespace halbench::firmware
