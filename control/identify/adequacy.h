#pragma once

#include "control/base/result.h"

#include <span>

namespace halbench::control {

/// Lack-of-fit F test: residual scatter around the line against the scatter of repeated points.
struct LackOfFit {
    double ratio = 0.0;       ///< F
    double probability = 1.0; ///< of a larger F when the model is adequate
    int lackFreedom = 0;
    int pureFreedom = 0;
};

/// `levels`: the setting of each point; points of equal level (to 1e-9 relative) are repeats. `parameters`:
/// number of fitted coefficients. Errors: Refused when nothing was repeated or no level is left over.
/// Source: resources/help/identification.md section 5.
Result<LackOfFit> testLackOfFit(std::span<const double> levels, std::span<const double> residuals,
                                int parameters);

/// Runs test (Wald and Wolfowitz) on the signs of residuals in the given order: too few runs mean curvature
/// or drift. Normal approximation with continuity correction; with fewer than five points of a sign it says
/// nothing (probability 1).
struct RunsTest {
    int runs = 0;
    double expected = 0.0;
    double probability = 1.0; ///< of so few runs or fewer by chance (one-sided)
};
RunsTest testRuns(std::span<const double> residuals);

} // namespace halbench::control
