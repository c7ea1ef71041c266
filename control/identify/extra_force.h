#pragma once

#include "control/identify/motion_fit.h"

namespace halbench::control {

/// Forces over J that the motor's model does not hold; s is the direction, omega the speed, t the time of the
/// recording from -1 to 1.
enum class ExtraForce {
    QuadraticDrag,      ///< -b omega |omega|
    Stribeck,           ///< -b s exp(-(omega/omega_s)^2)
    DampingByDirection, ///< -b |omega|: the damping differs between the directions by 2 b
    DampingByCurrent,   ///< -b I^2 omega: the angle of the torque moves with the current
    DampingDrift,       ///< -b t omega: the damping changes in the course of the recording
};

struct ExtraForceTerm {
    ExtraForce force = ExtraForce::QuadraticDrag;
    double stribeckSpeed_rad_s = 0.0;
    double value = 0.0;       ///< b: 1/rad, rad/s^2, 1/s, 1/(s A^2), 1/s
    double error = 0.0;       ///< 1 sigma, segments as clusters
    double freedom = 0.0;     ///< of Student's t
    double probability = 1.0; ///< of a larger term by chance, for all terms that are tried together
};

/// Acceleration that b = 1 gives at this steady speed and current, in the middle of the recording.
double extraForceAtSpeed_rad_s2(const ExtraForceTerm& term, double speed_rad_s, double current_A);

/// The motion with what the data ask for besides a, K_f and phi.
struct ExtraForceFit {
    MotionFit motion;                  ///< damping and balances beside the terms, which widen their errors
    std::vector<ExtraForceTerm> terms; ///< none, one or two that are significant
    std::optional<ExtraForceTerm> suspect; ///< the most probable of those that are not in the fit
    bool isAdequate = true;                ///< no further term is significant
};

struct ExtraForceConfig {
    MotionFitConfig motion;     ///< as the fit was made
    double significance = 1e-3; ///< probability below which a term is taken
    double slowest_rad_s = 3.0; ///< of the motion that was fitted
};

/// Score tests of terms that the residuals of `fit` may hold, and the fit with those that they do hold.
///
/// With L theta = theta'' + a0 theta' for the damping a0 that was found without the terms, the motion is
///     L theta = alpha - (a - a0) omega - sum b_i g_i(omega, t),
/// linear in a - a0 and all b once the course of the speed is known; the course comes from the fit before
/// and is corrected by the fit itself. Errors by CR2 over segments; with fewer than ten segments no less than
/// those of the rows, whose neighbours are correlated. Several Stribeck speeds are tried, and all terms
/// count in the probability (Bonferroni). Cost: that of solveMotion() times twenty. Errors: that of
/// checkAbort; Refused when the motion cannot tell any term from damping. Source:
/// resources/help/identification.md section 5.1.
Result<ExtraForceFit> fitExtraForces(std::span<const MotionSegment> segments, const MotionFit& fit,
                                     const ExtraForceConfig& config);

} // namespace halbench::control
