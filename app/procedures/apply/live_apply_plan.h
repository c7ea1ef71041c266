#pragma once

#include "app/procedures/move/motion_envelope.h"
#include "app/procedures/tune/tune.h"

#include <vector>

namespace halbench::app {

/// A way from the gains that run to other ones, and what may be expected on it.
struct LiveApplyConfig {
    control::PositionLaw target;
    MotorEstimate motor; ///< with its covariance
    LoopConditions conditions;
    UncertaintyDraws draws;
    double largestStep_ratio = 1.5; ///< K_P, and K_P + K_D/T_s, change by no more in one step
    double amplitude_rad = 0.5;     ///< of the move that follows each step, once this way, once that way
    double duration_s = 2.0;
};

/// One set of gains on the way, judged before it is written.
struct LiveStep {
    control::PositionLaw law;
    control::Robustness robust;
    MotionEnvelope band; ///< of a step of the reference by the amplitude; what leaves it ends everything
};

/// The sets of gains between the two and the target itself: straight lines, as long as the largest step
/// allows. Errors: OutOfRange (a step that allows no change; more than forty), NotFinite.
Result<std::vector<control::PositionLaw>> lawsBetween(const control::PositionLaw& from,
                                                      const LiveApplyConfig& config);

/// Every step with its judgement and its band: nine tenths of three hundred motors, twice as wide. Errors:
/// Refused when any set on the way is unstable, or has no margin, for the motor or for one in a hundred that
/// its uncertainty allows: then nothing may be written; Refused for a motor without covariance; of the gains.
Result<std::vector<LiveStep>> planLiveApply(const control::PositionLaw& from, const LiveApplyConfig& config);

} // namespace halbench::app
