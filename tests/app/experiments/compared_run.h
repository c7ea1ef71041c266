#pragma once

#include "app/recordings/run_comparison.h"

#include <memory>
#include <string>

namespace halbench::app {

/// 100 rows of 10 ms from a time on; the position is the time, the current is one.
inline ComparedRun runOf(const std::string& name, double from_s) {
    ComparedRun run;
    run.name = name;
    run.recording.layout = std::make_shared<const StreamLayout>(
        StreamLayout{{{"position", "rad"}, {"current.command", "A"}}, 0.01});
    for (int row = 0; row < 100; ++row) {
        run.recording.time_s.push_back(from_s + row * 0.01);
        run.recording.values.insert(run.recording.values.end(), {run.recording.time_s.back(), 1.0});
    }
    return run;
}

} // namespace halbench::app
