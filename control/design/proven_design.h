#pragma once

#include "control/design/optimal_designs.h"

namespace halbench::control {

/// For the designs of optimal_designs.h: the gains with their proof. Errors: of the inputs; Refused when they
/// are unstable on the board.
Result<ProvenDesign> provenDesign(const PositionPlant& plant, const PidGains& gains, const LoopTiming& timing,
                                  double currentLimit_A);

/// OutOfRange, for targets that are no numbers above zero.
tl::unexpected<Error> impossibleTargets();

} // namespace halbench::control
