#pragma once

#include "control/law/shaped_law.h"
#include "control/robustness/robustness.h"

namespace halbench::control {

/// `assessRobustness` over the same draws, one motor after the other: about a second for a thousand.
Result<Robustness> assessShaped(const UncertainPlant& plant, const ShapedLaw& law, const LoopTiming& timing,
                                int draws, Random random);

} // namespace halbench::control
