#pragma once

#include "control/identify/frequency_estimate.h"
#include "control/identify/joint_estimate.h"

#include <complex>
#include <span>

namespace halbench::control {

/// A rotor under held current as the loop sees it: psi'' + a psi' = k i, the current behind its command by a
/// lag of first order, and an angle that the current itself shifts (what the compensation of the coils' stray
/// field leaves). A sample is taken before its own current is set, so that it shows the current before.
struct SampledPlantModel {
    double dampingRate_1_s = 0.0;           ///< a = c/J
    double accelerationGain_rad_s2_A = 0.0; ///< k = phi/J
    double lag_s = 0.0;
    double feedthrough_rad_per_A = 0.0;
};

/// Command to sampled angle at e^(j w T), by Poisson's sum over the images of the sampling
///
///     G = kappa e^(-j w T) + (1 - e^(-j w T))/T sum_n k / ((j w_n)^2 (j w_n + a)(1 + lag j w_n)),   w_n = w
///     + 2 pi n/T
///
/// with 401 of them: 1e-6 of the value, or better. 0 < w <= pi/T.
std::complex<double> sampledPlantResponse(const SampledPlantModel& rotor, double period_s,
                                          double frequency_rad_s);

struct FrequencyFit {
    Estimate dampingRate;      ///< c/J, 1/s
    Estimate accelerationGain; ///< phi/J, rad/s^2/A
    Estimate feedthrough;      ///< rad/A
    double misfit_ratio =
        0.0; ///< root of the mean square of residuals over what the points scatter; 1: as expected
    SampledPlantModel rotor;
    int points = 0;
};

/// Weighted least squares of the complex values, each weighted with its own scatter, over a, k and the
/// feed-through; `lag_s` is known. The intervals are widened when the points scatter more than they should.
/// `gainError_ratio`: 95 % of the current's own scale, which no response can show; part of k's interval.
/// Errors: Refused (fewer than five points, nothing to tell the three apart).
Result<FrequencyFit> fitSampledPlant(std::span<const PlantPoint> points, double period_s, double lag_s,
                                     double gainError_ratio);

} // namespace halbench::control
