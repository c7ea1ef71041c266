#pragma once

#include "control/analysis/margins.h"
#include "control/robustness/robustness.h"

#include <vector>

namespace halbench::control {

/// The loop of one drawn motor.
struct SampledAssessment {
    bool isStable = false;
    StabilityMargins margins;
};

/// With what a loop beyond the limit must not count with taken out: it may cross with margins that look fine.
SampledAssessment sampledAssessment(bool isStable, const StabilityMargins& margins);
/// Of a draw that is no motor.
SampledAssessment noMotor();

/// Of at least one draw. Without uncertainty nothing is known of the intervals.
Robustness robustnessOf(const std::vector<SampledAssessment>& draws, bool isUncertain);
bool isUncertain(const UncertainPlant& plant);

} // namespace halbench::control
