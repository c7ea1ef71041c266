#pragma once

#include "control/assess/loop_assessment.h"
#include "control/lti/delta_system.h"

namespace halbench::control {

/// What a proof says of the loop alone, whatever its controller is made of: stability, margins, peaks, the
/// step of 1 rad and its use of the current, and the same loop one sample later. Noise and gains are left at
/// 0.
LoopAssessment assessOpenLoop(const DeltaSystem& openLoop, double poleRadius, double poleRadiusOneSampleLater,
                              LoopStep step, double currentLimit_A);

} // namespace halbench::control
