#pragma once

#include "tests/devices/firmware/avr/simavr/avr_board.h"
#include "tests/devices/firmware/line/board_line.h"

namespace halbench::simavr {

/// The motor's board on a line. Opening the port resets it, as the DTR line of an Arduino does.
class ServedAvrBoard : public firmware::ServedBoard {
public:
    explicit ServedAvrBoard(std::shared_ptr<AvrBoard> board) : m_board(std::move(board)) {}

    void lineOpened() override { m_board->core().reset(); }
    Result<void> send(std::span<const std::uint8_t> octets) override {
        m_board->core().send(octets);
        return {};
    }
    std::vector<std::uint8_t> take() override { return m_board->core().take(); }
    double time_s() const override { return m_board->time_s(); }
    Result<void> advanceTo(double time_s) override {
        m_board->advanceTo(time_s);
        return {};
    }

private:
    std::shared_ptr<AvrBoard> m_board;
};

} // namespace halbench::simavr
