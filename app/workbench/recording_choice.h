#pragma once

namespace halbench::app {

constexpr double LongestBefore_s = 300.0;  ///< is kept in memory
constexpr double LongestAfter_s = 86400.0; ///< of a recording that ends by itself

/// When a recording begins and ends, as the Record panel has it and a project keeps it.
struct RecordingChoice {
    double before_s = 0.0;    ///< kept from before the start
    bool isAtTrigger = false; ///< Ctrl+R waits for the Monitor's trigger
    double after_s = 0.0;     ///< with the trigger: so long after it, it ends; 0: by hand

    bool operator==(const RecordingChoice&) const = default;
};

} // namespace halbench::app
