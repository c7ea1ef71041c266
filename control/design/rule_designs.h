#pragma once

#include "control/base/result.h"
#include "control/design/design_methods.h"
#include "control/design/optimal_designs.h"
#include "control/design/tuning_rules.h"

#include <optional>
#include <string_view>

namespace halbench::control {

/// What a rule of the books is asked.
struct RuleProblem {
    PositionPlant plant;
    LoopTiming timing;
    DesignTargets targets;
};

/// simc, lambda, ziegler-nichols(-pi, -p), lqr, min-iae, min-itae and lag, carried to this motor and its
/// board: gains of the board (parallel, per radian), judged on the sampled loop with its delay. Defaults and
/// formulas are in resources/help/tuning.md. Nothing for any other method. Errors: OutOfRange (a motor that
/// the rule cannot take), Refused (unstable on this motor).
std::optional<Result<PidGains>> designByRule(std::string_view method, const RuleProblem& problem);

} // namespace halbench::control
