#pragma once

#include "control/law/shaped_law.h"
#include "control/robustness/load_band.h"
#include "control/robustness/uncertainty_bands.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace halbench::control {

// The bands of drawn motors under a shaped law; with nothing shaped those of the board's own to rounding.
// Errors: as of theirs, and of the law. O(plants x points): some tenths of a second for a thousand motors.

Result<LoopBands> shapedLoopBands(const std::vector<PositionPlant>& plants, const ShapedLaw& law,
                                  const LoopTiming& timing, const std::vector<double>& frequency_rad_s);
Result<StepBand> shapedStepBand(const std::vector<PositionPlant>& plants, const ShapedLaw& law,
                                const LoopTiming& timing, double amplitude_rad, double duration_s,
                                int pointsPerSample = 1,
                                std::size_t mostPoints = std::numeric_limits<std::size_t>::max());
Result<LoadBand> shapedLoadBand(const std::vector<PositionPlant>& plants, const ShapedLaw& law,
                                const LoopTiming& timing, double load_A, double duration_s,
                                int pointsPerSample = 5,
                                std::size_t mostPoints = std::numeric_limits<std::size_t>::max());

} // namespace halbench::control
