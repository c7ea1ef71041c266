#pragma once

#include "app/procedures/analyse.h"
#include "control/design/load_step.h"

namespace halbench::app {

/// The load of the prediction: a torque that so much current would make.
constexpr double DisturbanceLoad_A = 0.5;

/// What the load does to a loop that was analysed, as long as its step is shown; nothing for an unstable one
/// (resources/help/tuning.md, "Disturbance").
std::optional<control::LoadStep> disturbanceStep(const MotorEstimate& estimate,
                                                 const control::PositionLaw& law,
                                                 const LoopConditions& conditions,
                                                 const AnalysisResult& analysed);

} // namespace halbench::app
