#pragma once

#include "control/analysis/margins.h"
#include "control/robustness/robustness.h"

#include <vector>

namespace halbench::control {

/// The loop of one drawn plant; one that is no motor is not stable.
struct SampledAssessment {
    bool isStable = false;
    StabilityMargins margins; ///< of an unstable loop without meaning: it may cross with some that look fine
};

/// Of at least one draw. Without uncertainty nothing is known of the intervals.
Robustness robustnessOf(const std::vector<SampledAssessment>& draws, bool isUncertain);
bool isUncertain(const UncertainPlant& plant);

} // namespace halbench::control
