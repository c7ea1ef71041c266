#pragma once

#include "control/design/loop_batch.h"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace halbench::control {

// What the bands over drawn motors share: the law of `linearStep` on many motors in step.

constexpr int LaneWidth = 16; ///< lanes that go together: their state stays in the nearest memory
using LaneCurves = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic>; ///< lane by point

/// Which points of how many are kept: `most` of them, closer together at the beginning.
std::vector<std::size_t> keptPoints(std::size_t points, std::size_t most);

/// What is asked of every lane: a step of the reference, a load as the current that is worth as much, or
/// both.
struct LaneRun {
    double reference_rad = 0.0;
    double load_A = 0.0;
    int pointsPerSample = 1;
    std::vector<std::size_t> kept; ///< ascending
};

/// The angle of up to `LaneWidth` lanes from `first` on at the kept points, into the rows of `curves` from
/// `row` on.
void runLanes(const LoopBatch& batch, std::size_t first, const LaneRun& run, LaneCurves& curves,
              std::size_t row);

} // namespace halbench::control
