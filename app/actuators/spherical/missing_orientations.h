#pragma once

#include "models/spherical/calibration_fit.h"
#include "models/spherical/orientation.h"

#include <string>
#include <vector>

namespace halbench::app {

/// Orientations that would add most to what a motion tells least, the best first, at least 30 degrees apart.
std::vector<models::OrientationAngles> missingOrientations(const models::SphericalCalibration& nominal,
                                                           const models::CalibrationExcitation& excitation,
                                                           const models::CalibrationConfig& config,
                                                           std::size_t count);

/// "alpha 40, beta -40, gamma 0 deg"
std::string orientationText(const models::OrientationAngles& angles);

} // namespace halbench::app
