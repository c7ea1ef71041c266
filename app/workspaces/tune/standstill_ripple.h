#pragma once

#include "app/procedures/tune/tune.h"
#include "app/workbench/display_quantity.h"
#include "control/base/sample_block.h"

#include <optional>

namespace halbench::app {

/// What current and measured angle do around their means when a step has come to rest, rms.
struct StandstillRipple {
    double current_A = 0.0;
    double angle_rad = 0.0;
    /// What independent errors of that size in each measured angle make the law ask for:
    /// angle * sqrt((K_P + K_D/T_s)^2 + (K_D/T_s)^2).
    double explained_A = 0.0;
};

/// Of the last fifth of a recording; nothing without both signals. Jumps are left out: the middle nine tenths
/// of the samples count.
std::optional<StandstillRipple> standstillRipple(const Recording& recording, const control::PidGains& gains,
                                                 double period_s);

/// Why the current is not quiet at rest, in a sentence; empty when it is.
QString rippleWords(const StandstillRipple& ripple, const DisplayUnits& units);

} // namespace halbench::app
