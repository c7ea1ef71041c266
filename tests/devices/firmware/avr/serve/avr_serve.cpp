#include "tests/devices/firmware/avr/simavr/served_avr_board.h"

#include <fmt/format.h>

#include <csignal>
#include <cstdio>

// usage: avr_serve PROGRAM.elf
// Prints "listening serial:/dev/pts/N" and runs the board beside its motor until it is interrupted.

namespace {

std::atomic<int> Ending{0};

void end(int) {
    Ending = 1;
}

} // namespace

int main(int count, char** arguments) {
    using namespace halbench;
    if (count != 2) {
        fmt::print(stderr, "usage: avr_serve PROGRAM.elf\n");
        return 2;
    }
    auto board = simavr::AvrBoard::make(arguments[1], models::HtmParameters{}, 1);
    if (!board) {
        fmt::print(stderr, "{}\n", board.error().message);
        return 1;
    }
    const auto line = firmware::BoardLine::open(
        std::make_shared<simavr::ServedAvrBoard>(std::shared_ptr<simavr::AvrBoard>(std::move(*board))));
    if (!line) {
        fmt::print(stderr, "{}\n", line.error().message);
        return 1;
    }
    std::signal(SIGINT, &end);
    std::signal(SIGTERM, &end);
    fmt::print("listening serial:{}\n", (*line)->path());
    std::fflush(stdout);
    (*line)->serve(Ending);
    return 0;
}
