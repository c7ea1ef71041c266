#pragma once

#include "app/procedures/tune/analyse.h"

namespace halbench::app {

/// The law as the event-exact simulation runs it, in the board's notation. Errors: of the gains.
Result<control::SampledPositionLaw> simulatedLaw(const LoopLaw& law, const LoopConditions& conditions);

/// Event-exact simulation of the ideal loop (help: htm-theory.md 8, level A) over this time. The law must
/// have passed runAnalysis; Errors: of the inputs.
Result<LargeStep> predictLargeStep(const control::PositionPlant& plant, const LoopLaw& law,
                                   const LoopConditions& conditions, double amplitude_rad, double duration_s);
/// The same over 5 s, or 20 s where the rotor has not arrived by then. Errors: likewise.
Result<LargeStep> predictLargeStep(const control::PositionPlant& plant, const LoopLaw& law,
                                   const LoopConditions& conditions, double amplitude_rad);

} // namespace halbench::app
