#pragma once

#include "app/procedures/analyse.h"

namespace halbench::app {

/// A reference step of the motor with its friction and the current limit: where the linear loop promises too
/// much or, thanks to friction, too little.
struct LargeStep {
    double amplitude_rad = 0.0;
    control::StepMetrics metrics;
};

/// Event-exact simulation of the ideal loop (help: htm-theory.md 8, level A) over 5 s. The law must have
/// passed runAnalysis. Errors: of the inputs.
Result<LargeStep> predictLargeStep(const control::PositionPlant& plant, const control::PositionLaw& law,
                                   const LoopConditions& conditions, double amplitude_rad);

} // namespace halbench::app
