#include "devices/transport/board_server.h"

#include <algorithm>
#include <chrono>

namespace halbench::devices {

namespace {

constexpr int Tick_ms = 1;
/// A host that slept longer lets the board sleep too.
constexpr double MaxCatchUp_s = 0.5;
/// So much of the board's time at once: what it sends meanwhile fits its queue, which overflows otherwise.
constexpr double Piece_s = 0.01;

} // namespace

void serveBoard(ServerPort& port, ServedBoard& board, const std::atomic<int>& interruptSignal) {
    using WallClock = std::chrono::steady_clock;
    auto last = WallClock::now();
    double board_s = 0.0;
    while (interruptSignal.load() == 0) {
        port.waitForTraffic(Tick_ms);
        const auto now = WallClock::now();
        const double until_s =
            board_s + std::min(std::chrono::duration<double>(now - last).count(), MaxCatchUp_s);
        last = now;
        do {
            board_s = std::min(board_s + Piece_s, until_s);
            board.advanceTo(board_s);
            port.advanceTo(board_s);
            port.exchange(board);
        } while (board_s < until_s && interruptSignal.load() == 0);
    }
}

} // namespace halbench::devices
