#pragma once

#include "app/procedures/identify/identify_estimate.h"

#include <span>

namespace halbench::app {

/// Motion below the usable speed is left out.
control::SegmentConfig segmentConfigOf(const IdentifyConfig& config);

/// Motion, balance and the forces that the model lacks from all stretches that move; why there is none goes
/// into `fits` as well. Errors: that of `checkAbort`.
Result<void> fitTransients(std::span<const double> time_s, std::span<const double> angle_rad,
                           std::span<const control::CurrentPlateau> plateaus, const IdentifyConfig& config,
                           const AbortCheck& checkAbort, IdentifyFits& fits);

} // namespace halbench::app
