#pragma once

#include "control/base/sample_block.h"

#include <mutex>
#include <optional>
#include <string>

namespace halbench::app {

/// Rows of a motion that is recorded for a calibration while it runs. Thread: take() on the procedure's, the
/// others on any.
class LiveMotion {
public:
    /// Rows of the streams with nine fields; others are not kept.
    void take(const SampleBlock& block);

    Recording rows() const;
    double elapsed_s() const; ///< device time between the first row and the last
    /// Latest value of a signal; empty before the first row, without that column, or where it is not finite.
    std::optional<double> latest(const std::string& signal) const;

private:
    mutable std::mutex m_mutex; ///< guards all below
    Recording m_rows;
};

} // namespace halbench::app
