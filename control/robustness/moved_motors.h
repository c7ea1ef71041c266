#pragma once

#include "control/robustness/lane_motion.h"
#include "control/robustness/load_band.h"
#include "control/robustness/uncertainty_bands.h"

#include <cstddef>
#include <functional>
#include <optional>

namespace halbench::control {

// What the bands over drawn motors are made of, whatever law moves the motors.

struct MovedMotors {
    std::size_t count = 0;
    double period_s = 0.0;
    /// As `runLanes`: up to `LaneWidth` motors from the first on, into the rows from `row` on.
    std::function<void(std::size_t first, const LaneRun& run, LaneCurves& curves, std::size_t row)> run;
    /// As `middleOfLanes`.
    std::function<std::optional<Band>(const LaneRun& run)> middle;
};

/// Those of the board's law; the batch must live as long.
MovedMotors movedMotors(const LoopBatch& batch);

/// `middle` of motors that cannot stop and go on: where `mostValues` are not enough for all points, each part
/// is run from the beginning.
std::optional<Band> middleByParts(const MovedMotors& motors, const LaneRun& run,
                                  std::size_t mostValues = MostLaneValues);

/// `stepBand` and `loadBand` of them; `final_rad` is where the load leaves a motor in the end.
Result<StepBand> stepBandOf(const MovedMotors& motors, double amplitude_rad, double duration_s,
                            int pointsPerSample, std::size_t mostPoints);
Result<LoadBand> loadBandOf(const MovedMotors& motors, double final_rad, double load_A, double duration_s,
                            int pointsPerSample, std::size_t mostPoints);

} // namespace halbench::control
