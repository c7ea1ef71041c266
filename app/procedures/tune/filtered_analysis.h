#pragma once

#include "app/procedures/tune/analyse.h"

namespace halbench::app {

/// `runAnalysis` of a law with set-point weights and filters, which must be there: every figure and curve is
/// that of the filtered loop. The finding `needs_filtered_law` says that the plain law does not run it.
/// Errors: of the inputs.
Result<AnalysisResult> analyseFiltered(const control::PositionPlant& plant, const LoopLaw& law,
                                       const LoopConditions& conditions);

} // namespace halbench::app
