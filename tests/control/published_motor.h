#pragma once

#include "control/law/position_loop.h"

namespace halbench::control {

constexpr LoopTiming NoDelay{0.01, 0};

/// The motor of the publication (resources/help/htm-theory.md 2): c/J, phi/J, K_f/phi.
inline PositionPlant published() {
    return {1.23e-3 / 5.5e-4, 1.43e-2 / 5.5e-4, 2.05e-2 / 1.43e-2};
}

/// About what is recommended for it, per radian.
inline PidGains recommended() {
    PidGains gains;
    gains.proportional = 40.0;
    gains.integral = 60.0;
    gains.derivative = 1.4;
    return gains;
}

} // namespace halbench::control
