#pragma once

#include "control/robustness/loop_batch.h"
#include "control/robustness/uncertainty_bands.h"

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace halbench::control {

// What the bands over drawn motors share: the law of `linearStep` on many motors in step.

constexpr int LaneWidth = 16; ///< lanes that go together: their state stays in the nearest memory
using BatchCurves = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic>; ///< lane by point

/// Which points of how many are kept: `most` of them, closer together at the beginning.
std::vector<std::size_t> keptPoints(std::size_t points, std::size_t most);

/// What is asked of every lane: a step of the reference, a load as the current that is worth as much, or
/// both.
struct BatchRun {
    double reference_rad = 0.0;
    double load_A = 0.0;
    int pointsPerSample = 1;
    std::vector<std::size_t> kept; ///< ascending
};

/// Up to `LaneWidth` lanes on their way, to go on from where they are.
struct BatchState {
    static constexpr std::size_t MostPending = 16;
    using Lanes = Eigen::Array<double, LaneWidth, 1>;

    std::array<Lanes, MostPending> pending;
    Lanes angle = Lanes::Zero();
    Lanes speed = Lanes::Zero();
    Lanes integral = Lanes::Zero();
    Lanes last = Lanes::Zero();
    Lanes current = Lanes::Zero();
    std::size_t sample = 0;
    std::size_t point = 0;
    std::size_t next = 0; ///< of the kept points

    BatchState() { pending.fill(Lanes::Zero()); }
};

/// The angle of up to `LaneWidth` lanes from `first` on at the kept points, into the rows of `curves` from
/// `row` on.
void runBatch(const LoopBatch& batch, std::size_t first, const BatchRun& run, BatchCurves& curves,
              std::size_t row);
/// The same from `state` up to the kept point `until`, into the first columns; the steps are the same ones,
/// wherever they are interrupted.
void runBatch(const LoopBatch& batch, std::size_t first, const BatchRun& run, BatchState& state,
              std::size_t until, BatchCurves& curves, std::size_t row);

/// Which lanes of some curves stayed within all numbers: what once is none stays so.
std::vector<Eigen::Index> finiteLanes(const BatchCurves& curves);

/// Values that a band holds at once: 32 MB. A slow loop has some ten thousand points of a thousand motors.
constexpr std::size_t MostLaneValues = 4000000;

/// At each kept point the middle nine tenths of all lanes that stay within numbers; nothing when none does.
/// Where `mostValues` are not enough for all points, they are computed part by part, after the end has shown
/// which lanes those are.
std::optional<Band> middleOfLanes(const LoopBatch& batch, const BatchRun& run,
                                  std::size_t mostValues = MostLaneValues);
/// The same of curves that are there, of these lanes.
Band middleOfLanes(const BatchCurves& curves, const std::vector<Eigen::Index>& lanes);

} // namespace halbench::control
