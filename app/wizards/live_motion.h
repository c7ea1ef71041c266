#pragma once

#include "control/base/sample_block.h"

#include <Eigen/Core>
#include <mutex>
#include <optional>

namespace halbench::app {

/// Rows of a motion that is recorded for a calibration while it runs, and the orientation that the board
/// measured last. Thread: take() on the procedure's, the others on any.
class LiveMotion {
public:
    /// Rows of the streams with nine fields; others are not kept.
    void take(const SampleBlock& block);

    Recording rows() const;
    double elapsed_s() const; ///< device time between the first row and the last
    /// Rotation from rotor to stator; empty before the first row.
    std::optional<Eigen::Matrix3d> orientation() const;

private:
    mutable std::mutex m_mutex; ///< guards all below
    Recording m_rows;
};

} // namespace halbench::app
