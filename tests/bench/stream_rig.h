#pragma once

#include "devices/device.h"
#include "devices/link_orders.h"
#include "tests/bench/fast_board.h"
#include "tests/bench/goal.h"

#include <functional>
#include <memory>
#include <string>

namespace halbench::bench {

/// A way to the synthetic board.
struct BoardLine {
    std::string name; ///< "over TCP"
    FastBoard* board = nullptr;
    std::function<Result<std::unique_ptr<devices::Device>>(const std::shared_ptr<devices::LinkOrders>&)> open;
    /// Processor time that the program's side of the line has used, s; none: that of the calling thread.
    std::function<double()> used_s;
};

/// Processor time that a thread, or that of the clock, has used, s.
double threadTime_s(pthread_t thread);
double clockTime_s(clockid_t clock);

/// 32 signals at 20 kHz: every row there, every value right, a quarter of a core at most.
void benchStream(Goals& goals, const BoardLine& line, double duration_s);

/// How soon a stop reaches the board at that stream, against how late this machine wakes a thread.
void benchStop(Goals& goals, const BoardLine& line);

/// What else runs on this machine.
void printLoad();

} // namespace halbench::bench
