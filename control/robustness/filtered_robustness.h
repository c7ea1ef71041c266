#pragma once

#include "control/law/filtered_law.h"
#include "control/robustness/robustness.h"

namespace halbench::control {

/// `assessRobustness` over the same draws, one motor after the other: about a second for a thousand.
Result<Robustness> assessFiltered(const UncertainPlant& plant, const FilteredLaw& law,
                                  const LoopTiming& timing, int draws, Random random);

} // namespace halbench::control
