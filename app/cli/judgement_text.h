#pragma once

#include "app/procedures/tune/tune.h"

#include <string>

namespace halbench::app {

// Assessment of gains as text of the terminal: lines of `tune` and `analyse`.

/// Noise, current and the sample that may come late; empty for a loop that grows beyond all numbers.
std::string proofLines(const TuneResult& result);
/// Friction band at rest and predicted limit cycles.
std::string cycleLines(const TuneResult& result);
/// Response to a load; empty for an unstable loop.
std::string disturbanceLines(const TuneResult& result);
/// Interval of each margin over the uncertainty of the motor, or of what `drawn` are ("motors", "axes").
std::string intervalLines(const control::Robustness& robust, const std::string& drawn = "motors");

} // namespace halbench::app
