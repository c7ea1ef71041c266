#pragma once

#include "tests/devices/firmware/line/board_line.h"
#include "tests/devices/firmware/mps2/emulator/mps2_board.h"

namespace halbench::mps2 {

/// The board on a line, tick after tick; opening the port means nothing to it.
class ServedMps2Board : public firmware::ServedBoard {
public:
    explicit ServedMps2Board(std::shared_ptr<Mps2Board> board) : m_board(std::move(board)) {}

    void lineOpened() override {}
    Result<void> send(std::span<const std::uint8_t> octets) override { return m_board->send(octets); }
    std::vector<std::uint8_t> take() override { return m_board->take(); }
    double time_s() const override { return m_board->time_s(); }
    Result<void> advanceTo(double time_s) override {
        constexpr double Rounding_s = 1e-9;
        while (m_board->time_s() + Mps2Board::Tick_s <= time_s + Rounding_s) {
            if (auto ticked = m_board->tick(); !ticked) {
                return ticked;
            }
        }
        return {};
    }

private:
    std::shared_ptr<Mps2Board> m_board;
};

} // namespace halbench::mps2
