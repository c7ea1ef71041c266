#pragma once

#include "control/base/result.h"
#include "control/law/pid.h"

namespace halbench::control {

/// The gains as the board takes them: parallel form, per radian, the derivative as the difference over one
/// sample. Its law has no filter: one of 0 s is that difference, one on a derivative of zero does nothing,
/// and any other is refused rather than left out, because the loop would not be the one that was designed.
/// Errors: of `convert`; InvalidInput.
Result<PidGains> boardGains(const PidGains& gains);

} // namespace halbench::control
