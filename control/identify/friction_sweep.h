#pragma once

#include "control/base/result.h"
#include "control/identify/adequacy.h"

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace halbench::control {

/// Steady speed at one current; signs as on the device.
struct SteadyPoint {
    double current_A = 0.0;
    double speed_rad_s = 0.0;
    double speedError_rad_s = 0.0; ///< 1 sigma of the measurement alone
    /// 1 sigma of the one error that all points share, as it shifts this one (that of a correction, say).
    double sharedError_rad_s = 0.0;
    /// The same of a second one that is independent of it (that of the currents' bow, say).
    double settingError_rad_s = 0.0;
};

/// Result of the steady sweep. With s = +-1 the direction of motion:
///   s omega = b |I| + d_s,   c/phi = 1/b,   K_f,s/phi = -d_s/b,   K_f = (K_f+ + K_f-)/2.
struct FrictionSweep {
    double damping_A_s = 0.0;   ///< c/phi, ampere per rad/s
    double friction_A = 0.0;    ///< K_f/phi, breakaway current
    Eigen::Matrix2d covariance; ///< of (c/phi, K_f/phi)
    int freedom = 0;            ///< degrees of freedom of the intervals
    std::optional<double> frictionForward_A;
    std::optional<double> frictionReverse_A;
    std::optional<double> asymmetry; ///< (K_f+ - K_f-)/(K_f+ + K_f-), both directions only
    double asymmetryError = 0.0;
    double rSquared = 0.0;
    double residualRms_rad_s = 0.0;
    std::vector<double> residuals_rad_s;                ///< of s omega
    std::vector<double> robustWeights;                  ///< Huber
    bool isRobustDifferent = false;                     ///< by more than 1 sigma
    double largestInfluence = 0.0;                      ///< of one point on c or K_f, in standard errors
    std::vector<std::pair<double, double>> bootstrap95; ///< of c/phi and K_f/phi; empty if refused
    std::optional<LackOfFit> lackOfFit;
    RunsTest runs; ///< residuals in order of |speed|
};

/// Regression of speed on current: the current is known far better, the reverse regression would shrink the
/// slope by R^2. Common slope for both directions, an intercept for each; weights from the measuring error
/// plus the common run-to-run scatter; variances by the delta method. Each shared error u e is one more
/// unknown e with the prior N(0, 1); the second opinions see the speeds without it. Robust fit,
/// bootstrap, leave-one-out, lack of fit and runs test stand beside it. Errors: NotFinite; Refused (fewer
/// than three points more than directions, no different currents, speed not growing with current, a point at
/// rest or against its current). Source: resources/help/identification.md section 2.
Result<FrictionSweep> fitFrictionSweep(std::span<const SteadyPoint> points, std::uint64_t seed);

} // namespace halbench::control
