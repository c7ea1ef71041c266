#pragma once

#include "control/robustness/batch_simulation.h"
#include "control/robustness/disturbance_envelope.h"
#include "control/robustness/uncertainty_bands.h"

#include <cstddef>
#include <functional>
#include <optional>

namespace halbench::control {

// What the bands over drawn motors are made of, whatever law moves the motors.

struct SimulatedEnsemble {
    std::size_t count = 0;
    double period_s = 0.0;
    /// As `runBatch`: up to `LaneWidth` motors from the first on, into the rows from `row` on.
    std::function<void(std::size_t first, const BatchRun& run, BatchCurves& curves, std::size_t row)> run;
    /// As `middleOfLanes`.
    std::function<std::optional<Band>(const BatchRun& run)> middle;
};

/// Those of the board's law; the batch must live as long.
SimulatedEnsemble simulatedEnsemble(const LoopBatch& batch);

/// `middle` of motors that cannot stop and go on: where `mostValues` are not enough for all points, each part
/// is run from the beginning.
std::optional<Band> middleByParts(const SimulatedEnsemble& motors, const BatchRun& run,
                                  std::size_t mostValues = MostLaneValues);

/// `stepBand` and `disturbanceEnvelope` of them; `final_rad` is where the load leaves a motor in the end.
Result<StepBand> stepBandOf(const SimulatedEnsemble& motors, double amplitude_rad, double duration_s,
                            int pointsPerSample, std::size_t mostPoints);
Result<DisturbanceEnvelope> disturbanceEnvelopeOf(const SimulatedEnsemble& motors, double final_rad,
                                                  double load_A, double duration_s, int pointsPerSample,
                                                  std::size_t mostPoints);

} // namespace halbench::control
