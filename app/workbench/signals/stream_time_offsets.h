#pragma once

#include <utility>
#include <vector>

namespace halbench::app {

/// Time offsets of the history's rows: how much later it has them than the device's clock. A stream that
/// began anew follows the one before there (control/history/sample_history.h), by some milliseconds; a clock
/// that began again, by all of its time. Each stretch of the history keeps its own, so that a moment of the
/// plots can be told on the device's clock as exactly as its rows came. Thread: GUI.
class StreamTimeOffsets {
public:
    /// A block's rows are in the history from `begin_s` on, so much later than they say themselves.
    void note(double begin_s, double shift_s);
    /// Of a moment of the history; 0 where no row ever came.
    double at(double time_s) const;
    /// Of the newest rows.
    double newest() const { return m_stretches.empty() ? 0.0 : m_stretches.back().second; }

private:
    std::vector<std::pair<double, double>> m_stretches; ///< their begin and their shift, by time
};

} // namespace halbench::app
