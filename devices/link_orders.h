#pragma once

#include <atomic>
#include <cstdint>

namespace halbench::devices {

/// What other threads want of the one that waits for a board's answer; it looks here while it waits.
struct LinkOrders {
    std::atomic<std::uint64_t> stops = 0; ///< emergency stops asked for so far; each is sent at once
    std::atomic<bool> isLeaving = false;  ///< a board that is still being opened is given up
};

} // namespace halbench::devices
