#pragma once

#include "app/procedures/tune/analyse.h"
#include "control/assess/load_step.h"
#include "control/robustness/disturbance_envelope.h"

#include <optional>
#include <vector>

namespace halbench::app {

/// The load of the prediction: a torque that so much current would make.
constexpr double DisturbanceLoad_A = 0.5;

/// What the load does to a loop that was analysed, as long as its step is shown; nothing for an unstable one
/// (resources/help/tuning.md, "Disturbance").
std::optional<control::LoadStep> disturbanceStep(const MotorEstimate& estimate, const LoopLaw& law,
                                                 const LoopConditions& conditions,
                                                 const AnalysisResult& analysed,
                                                 double load_A = DisturbanceLoad_A);

/// A load with what it does, and what the uncertainty of the motor makes of that.
struct Disturbance {
    double load_A = DisturbanceLoad_A;
    control::LoadStep step;
    std::optional<control::DisturbanceEnvelope> band; ///< nothing: the motor's uncertainty is not known
};
/// The same with the motors of `plants`, none of them for a motor without covariance. Nothing for an unstable
/// loop.
std::optional<Disturbance> disturbanceOf(const MotorEstimate& estimate, const LoopLaw& law,
                                         const LoopConditions& conditions, const AnalysisResult& analysed,
                                         double load_A, const std::vector<control::PositionPlant>& plants);

} // namespace halbench::app
