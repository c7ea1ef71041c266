#pragma once

#include "app/procedures/tune.h"
#include "control/design/shaped_law.h"

namespace halbench::app {

/// The judgement of a loop that no board's law runs: set-point weights, filters. All figures are those of the
/// shaped loop; what needs friction, the current limit or a load beside it (large step, limit cycles, load)
/// is not predicted and says so. Unstable gains are refused. `extras` are the parts of the law beside its
/// gains. Errors: of plantFromEstimate, of the law.
Result<TuneResult> judgeShaped(const MotorEstimate& estimate, const control::ShapedLaw& shaped,
                               const control::PositionLaw& extras, const TuneConfig& config);

} // namespace halbench::app
