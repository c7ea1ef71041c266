#pragma once

#include "control/design/design_methods.h"

namespace halbench::control {

/// What is asked of a method, judged. Errors: NotFinite, OutOfRange, Usage (a target that the method does not
/// read, or that needs another one).
Result<void> checkTargets(const DesignMethod& method, const LoopTiming& timing, const DesignTargets& targets);

} // namespace halbench::control
