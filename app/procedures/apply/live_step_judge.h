#pragma once

#include "app/procedures/apply/live_apply_plan.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace halbench::app {

// The parts of planLiveApply(), for who has to serve a link between them.

/// Which step of how many, for words.
struct StepNumber {
    std::size_t number = 1;
    std::size_t count = 1;
};

/// The motors whose motions make the bands. Errors: as of planLiveApply().
Result<std::vector<RunMotor>> liveMotors(const LiveApplyConfig& config);

/// One set of gains, some tenths of a second. Errors: Refused when it is not safe; of the gains.
Result<LiveStep> judgeLiveStep(const control::PositionLaw& law, const std::vector<RunMotor>& motors,
                               const LiveApplyConfig& config, const StepNumber& step);

/// `afterEach` is asked after each set: a board whose master is silent for a second takes it for lost.
/// Errors: also those of `afterEach`.
Result<std::vector<LiveStep>> planLiveApply(const control::PositionLaw& from, const LiveApplyConfig& config,
                                            const std::function<Result<void>()>& afterEach);

} // namespace halbench::app
