#pragma once

#include "control/base/result.h"

#include <cstddef>
#include <functional>

namespace halbench::models {

/// How a long computation is watched and ended.
struct WorkControl {
    std::function<bool()> isStopped;        ///< asked between items, from every thread; empty: never
    std::function<void(double)> onProgress; ///< share done, 0 to 1, on the calling thread
    int threads = 0;                        ///< 0: as many as the machine has
};

/// Calls body(i) for every i in [0, count) on several threads; items must not depend on each other. Returns
/// when all threads have ended. Error: Interrupted when stopped.
Result<void> forEachInParallel(std::size_t count, const WorkControl& control,
                               const std::function<void(std::size_t)>& body);

} // namespace halbench::models
