#pragma once

#include "control/robustness/robustness.h"
#include "control/robustness/uncertainty_bands.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace halbench::control {

/// What the uncertainty of the motor makes of `loadStep`.
struct DisturbanceEnvelope {
    std::vector<double> time_s;
    Band angle_rad;
    Robustness::Interval peak_rad; ///< of each motor's own peak, wherever that is; towards the load
    /// Of each motor's own recovery; absent where more than one in twenty has not recovered in this time.
    std::optional<Robustness::Interval> recoveryTime_s;
};

/// Every motor of `drawPlants` under the same load. Of more points than `mostPoints` so many are kept, closer
/// together at the beginning. Peaks and recoveries are of all points; of more than 10 001, where a motor does
/// not ring, of points 0.5 % apart: a recovery is so exact. Errors: of gains
/// and timing; OutOfRange (extent); Refused (no motor among the plants).
Result<DisturbanceEnvelope>
disturbanceEnvelope(const std::vector<PositionPlant>& plants, const PidGains& gains, const LoopTiming& timing,
                    double load_A, double duration_s, int pointsPerSample = 5,
                    std::size_t mostPoints = std::numeric_limits<std::size_t>::max());

} // namespace halbench::control
