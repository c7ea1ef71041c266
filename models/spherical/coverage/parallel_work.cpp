#include "models/spherical/coverage/parallel_work.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace halbench::models {

Result<void> forEachInParallel(std::size_t count, const WorkControl& control,
                               const std::function<void(std::size_t)>& body) {
    std::atomic<std::size_t> next{0};
    std::atomic<std::size_t> done{0};
    std::atomic<bool> isStopped{false};
    const auto work = [&](bool reports) {
        while (!isStopped) {
            if (control.isStopped && control.isStopped()) {
                isStopped = true;
                return;
            }
            const std::size_t index = next++;
            if (index >= count) {
                return;
            }
            body(index);
            const std::size_t finished = ++done;
            if (reports && control.onProgress) {
                control.onProgress(static_cast<double>(finished) / static_cast<double>(count));
            }
        }
    };
    const std::size_t wanted = control.threads > 0
                                   ? static_cast<std::size_t>(control.threads)
                                   : std::max<std::size_t>(1, std::thread::hardware_concurrency());
    std::vector<std::thread> others;
    for (std::size_t i = 1; i < std::min(wanted, count); ++i) {
        others.emplace_back(work, false);
    }
    work(true);
    for (std::thread& thread : others) {
        thread.join();
    }
    if (isStopped) {
        return failure(ErrorCode::Interrupted, "The computation was stopped.");
    }
    return {};
}

} // namespace halbench::models
