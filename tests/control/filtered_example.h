#pragma once

#include "control/law/filtered_law.h"

namespace halbench::control {

// A law with weights and filters, for the motor of published_motor.h.

inline PidGains lively() {
    PidGains gains;
    gains.proportional = 12.0;
    gains.integral = 20.0;
    gains.derivative = 0.8;
    return gains;
}

/// The board's own.
inline FilteredLaw of(const PidGains& gains) {
    FilteredLaw law;
    law.gains = gains;
    return law;
}

inline FilteredLaw filtered() {
    FilteredLaw law = of(lively());
    law.gains.filter_s = 0.004;
    law.proportionalWeight = 0.6;
    law.derivativeWeight = 0.3;
    law.filters = {NotchFilter{180.0, 0.1, 0.5}, LowPassFilter{250.0, 2}};
    return law;
}

} // namespace halbench::control
