#pragma once

#include "control/base/units.h"

#include <algorithm>
#include <cmath>

namespace halbench::models {

/// Digital-to-analogue converter with the fixed offset that makes it bipolar: the amplifier's input is
///   V = V_ref (n + inl sin(2 pi n / 2^bits)) (1 + gain error) / 2^bits - offset.
/// The sine is one typical shape of an integral non-linearity: zero at both ends and at mid-scale, where the
/// offset trim is done, and at most `integralNonLinearity_codes` in between.
/// Source: resources/help/htm-theory.md sections 3.3 and 9 (+-2 codes, +-0.4 %).
struct DacConfig {
    double reference_V = 5.0;
    int bits = 12;
    double offset_V = 2.5;
    double integralNonLinearity_codes = 0.0;
    double gainError_ratio = 0.0;
};

inline double dacStep_V(const DacConfig& config) {
    return std::ldexp(config.reference_V, -config.bits);
}

/// The amplifier's input voltage for a code (a fraction is allowed: the ideal chain does not round).
inline double dacOutput_V(const DacConfig& config, double code) {
    const double bow =
        config.integralNonLinearity_codes * std::sin(2.0 * Pi * std::ldexp(code, -config.bits));
    return (code + bow) * dacStep_V(config) * (1.0 + config.gainError_ratio) - config.offset_V;
}

/// The code (with its fraction) at which a perfect converter gives this amplifier input.
inline double exactDacCode(const DacConfig& config, double output_V) {
    return (output_V + config.offset_V) / dacStep_V(config);
}

/// The nearest code there is: round half away from zero, clipped to 0 ... 2^bits - 1.
inline int nearestDacCode(const DacConfig& config, double output_V) {
    const double last = std::ldexp(1.0, config.bits) - 1.0;
    return static_cast<int>(std::clamp(std::round(exactDacCode(config, output_V)), 0.0, last));
}

} // namespace halbench::models
