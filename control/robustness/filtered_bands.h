#pragma once

#include "control/law/filtered_law.h"
#include "control/robustness/disturbance_envelope.h"
#include "control/robustness/uncertainty_bands.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace halbench::control {

// The bands of drawn motors under a filtered law; with nothing filtered those of the board's own to rounding.
// Errors: as of theirs, and of the law. O(plants x points): some tenths of a second for a thousand motors.

Result<LoopBands> filteredLoopBands(const std::vector<PositionPlant>& plants, const FilteredLaw& law,
                                    const LoopTiming& timing, const std::vector<double>& frequency_rad_s);
Result<StepBand> filteredStepBand(const std::vector<PositionPlant>& plants, const FilteredLaw& law,
                                  const LoopTiming& timing, double amplitude_rad, double duration_s,
                                  int pointsPerSample = 1,
                                  std::size_t mostPoints = std::numeric_limits<std::size_t>::max());
Result<DisturbanceEnvelope>
filteredDisturbanceEnvelope(const std::vector<PositionPlant>& plants, const FilteredLaw& law,
                            const LoopTiming& timing, double load_A, double duration_s,
                            int pointsPerSample = 5,
                            std::size_t mostPoints = std::numeric_limits<std::size_t>::max());

} // namespace halbench::control
