#pragma once

#include "control/base/result.h"

#include <span>

namespace halbench::control {

/// Speed of one plateau from a straight line through the unwrapped angle.
struct PlateauSpeed {
    double speed_rad_s = 0.0;
    double speedError_rad_s = 0.0; ///< 1 sigma from the residuals, sigma_theta sqrt(12)/(T sqrt(N))
    double angleNoise_rad = 0.0;   ///< rms about the line
};

/// Errors: Refused (fewer than three samples, or no time between them), NotFinite.
Result<PlateauSpeed> fitPlateauSpeed(std::span<const double> time_s, std::span<const double> angle_rad);

/// The same with the ripple of the Hall sensors' errors, once and twice per turn, fitted along: it would tilt
/// a line that does not hold very many turns. A window shorter than 1.5 turns gets the plain line.
Result<PlateauSpeed> fitRippledSpeed(std::span<const double> time_s, std::span<const double> angle_rad);

/// Whether the speed has settled: two successive windows of `window_s` at the end agree within
/// `tolerance_ratio`, or within three sigma of their difference where that is more.
struct SteadinessConfig {
    double window_s = 1.0;
    double tolerance_ratio = 1e-3;
};
struct Steadiness {
    bool isSteady = false;
    double earlier_rad_s = 0.0;
    double later_rad_s = 0.0;
    double sigma_rad_s = 0.0; ///< of the difference
};

/// The windows are lengthened to whole turns, so that they hold the same ripple, when the record allows. The
/// larger of the two conditions decides, so that a perfect record is not failed for its lack of noise.
/// Errors: Refused when the record is shorter than two windows.
Result<Steadiness> testSteadiness(std::span<const double> time_s, std::span<const double> angle_rad,
                                  const SteadinessConfig& config);

} // namespace halbench::control
