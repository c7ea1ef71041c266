#pragma once

#include "control/law/position_loop.h"

#include <functional>

namespace halbench::control {

/// Largest K_P up to which a loop of this motor is stable, to the last digits, from below; 0 when it is not
/// even for the smallest.
double largestStableGain(const PositionPlant& plant, const LoopTiming& timing,
                         const std::function<bool(double)>& isStableAt);

} // namespace halbench::control
