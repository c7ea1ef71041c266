#pragma once

#include "control/base/result.h"
#include "control/law/position_loop.h"
#include "control/lti/delta_system.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace halbench::control {

/// At each point of an axis, the 5th and the 95th percentile over the drawn plants: nine tenths of the motors
/// that the identification allows lie between, point by point (a single motor may leave the band somewhere).
struct Band {
    std::vector<double> p5;
    std::vector<double> p95;
};

/// Of the open loop over frequency. O(plants x frequencies).
struct LoopBands {
    std::vector<double> frequency_rad_s;
    Band magnitude_dB;
    Band phase_deg; ///< unwrapped as `phase_deg`
};
/// `plants` from `drawPlants`; those that are no motor are left out. Errors: of gains and timing; OutOfRange
/// (frequencies not ascending within the Nyquist frequency); Refused (no motor among the plants).
Result<LoopBands> loopBands(const std::vector<PositionPlant>& plants, const PidGains& gains,
                            const LoopTiming& timing, const std::vector<double>& frequency_rad_s);

/// The same with any controller in the place of the board's, at the sampling of `timing`.
Result<LoopBands> loopBands(const std::vector<PositionPlant>& plants, const DeltaSystem& controller,
                            const LoopTiming& timing, const std::vector<double>& frequency_rad_s);

/// Of the linear closed loop after a step of the reference. Plants whose loop grows beyond all numbers leave.
struct StepBand {
    std::vector<double> time_s;
    Band response_rad;
};
/// Of more points than `mostPoints` so many are kept, closer together at the beginning where more happens.
/// Errors: as above; OutOfRange (extent).
Result<StepBand> stepBand(const std::vector<PositionPlant>& plants, const PidGains& gains,
                          const LoopTiming& timing, double amplitude_rad, double duration_s,
                          int pointsPerSample = 1,
                          std::size_t mostPoints = std::numeric_limits<std::size_t>::max());

} // namespace halbench::control
