#pragma once

#include <cmath>

namespace halbench::models {

/// Analogue-to-digital converter of the board: code = floor(V 2^bits / V_ref), clipped to 0 ... 2^bits - 1.
/// Source: resources/help/htm-theory.md sections 2 and 3.4.
struct AdcConfig {
    double reference_V = 5.0;
    int bits = 10;
    bool isQuantised = true; ///< false: the ideal chain; the code keeps its fraction
};

/// The voltage of one code step, 4.8828 mV for ten bits of 5 V.
inline double adcStep_V(const AdcConfig& config) {
    return std::ldexp(config.reference_V, -config.bits);
}

/// The code the converter delivers, as a real number. The ideal chain delivers V / step - 1/2, so that the
/// one reconstruction rule of `adcVoltage_V` returns the exact voltage.
inline double adcCode(const AdcConfig& config, double voltage_V) {
    const double steps = voltage_V / adcStep_V(config);
    const double last = std::ldexp(1.0, config.bits) - 1.0;
    const double code = config.isQuantised ? std::floor(steps) : steps - 0.5;
    const double lowest = config.isQuantised ? 0.0 : -0.5;
    const double highest = config.isQuantised ? last : last + 0.5;
    return std::fmin(std::fmax(code, lowest), highest);
}

/// The middle of the code's interval: V = (code + 1/2) step.
inline double adcVoltage_V(const AdcConfig& config, double code) {
    return (code + 0.5) * adcStep_V(config);
}

} // namespace halbench::models
