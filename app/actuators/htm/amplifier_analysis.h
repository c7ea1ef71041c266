#pragma once

#include "models/drives/amplifier.h"

#include <optional>
#include <vector>

namespace halbench::app {

/// Frequency response of the amplifier from voltage to current, 1 Hz to 100 kHz, as in figure 7 of the
/// publication (resources/help/htm-theory.md 3.2 and section 5).
struct AmplifierAnalysis {
    double gain_A_per_V = 0.0;       ///< at 0 Hz
    double lagAt10Hz_deg = 0.0;      ///< positive: the current is behind
    std::optional<double> cutoff_Hz; ///< last frequency from which the gain stays 3 dB below the static one
    double magnitudeAt1kHz_dB = 0.0; ///< of A/V
    double phaseAt1kHz_deg = 0.0;
    double shuntPower_W = 0.0;     ///< in the current shunt R10 at the largest current, if it were one part
    double shuntPowerEach_W = 0.0; ///< in each of the two in parallel that the formula has (6.14)
    std::vector<double> frequency_Hz; ///< 50 points a decade
    std::vector<double> magnitude_dB; ///< of A/V
    std::vector<double> phase_deg;    ///< unwrapped
};

/// Pure function. Errors: OutOfRange (parts that are not positive).
Result<AmplifierAnalysis> analyseAmplifier(const models::AmplifierParts& parts, double largestCurrent_A);

} // namespace halbench::app
