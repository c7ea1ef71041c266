#pragma once

#include "app/procedures/tune/tune.h"

#include <string>

namespace halbench::app {

// What gains are judged by, for those who read it in a terminal: lines of `tune` and `analyse`.

/// Noise, current and the sample that may come late; empty for a loop that grows beyond all numbers.
std::string proofLines(const TuneResult& result);
/// What friction and the current limit make of the motion.
std::string cycleLines(const TuneResult& result);
/// What a load does; empty for an unstable loop.
std::string disturbanceLines(const TuneResult& result);
/// What the uncertainty of the motor makes of each margin.
std::string intervalLines(const control::Robustness& robust);

} // namespace halbench::app
