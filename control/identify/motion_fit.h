#pragma once

#include "control/identify/motion_segments.h"

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace halbench::control {

struct MotionFitConfig {
    int angleOrders = 6;    ///< orders per turn of the sensors' angle error that are fitted along
    bool fitsRipple = true; ///< torque and friction ripple once and twice per turn
    /// Torque of a current falls as 1 - L omega^2: hold between two commutations, roll-off and lag of the
    /// amplifier (resources/help/identification.md section 3.1). L is fitted along; this is what is assumed
    /// of it, with its 1 sigma, when the data cannot tell it any better.
    double torqueLoss_s2 = 0.0;
    double torqueLossError_s2 = 0.0;
    /// Asked between the steps of the fit; an error ends it. Empty: it goes on to its end.
    std::function<Result<void>()> checkAbort;
};

/// What one segment says about the balance of torques, all over J:
///   s (omega' + a omega) = (phi/J) s I - K_f,s/J,     s = direction.
struct SegmentBalance {
    double current_A = 0.0; ///< s I: positive drives, negative brakes
    int direction = 1;
    double balance_rad_s2 = 0.0;
    double error_rad_s2 = 0.0; ///< 1 sigma of the angle noise alone, damping known
    double slope_rad_s = 0.0;  ///< change of the balance with the damping a
    double residualRms_rad = 0.0;
};

/// One sigma of a cause of error that all segments share, as it moves the damping and the balances.
struct SharedError {
    double damping_per_s = 0.0;
    std::vector<double> balances_rad_s2;
};

/// Damping over inertia from the shape of all segments, balance of torques from each.
struct MotionFit {
    double damping_per_s = 0.0;           ///< a = c/J
    double dampingError_per_s = 0.0;      ///< 1 sigma, segments as independent clusters
    double dampingFreedom = 0.0;          ///< effective, of Student's t
    std::vector<SegmentBalance> balances; ///< in the order of the segments
    int angleOrders = 0;                  ///< orders that the data could carry
    std::vector<double> angleError_rad;   ///< of cos theta, sin theta, cos 2 theta, ... of the measured angle
    double residualRms_rad = 0.0;
    double torqueLoss_s2 = 0.0; ///< L, fitted or assumed
    double torqueLossError_s2 = 0.0;
    bool isTorqueLossFitted = false;
    std::vector<SharedError> sharedErrors;    ///< besides dampingError_per_s, independent of it
    std::vector<double> angleErrorSpread_rad; ///< 1 sigma of angleError_rad; empty below ten segments
};

/// Fits the measured angle, not a differentiated speed, of all segments at once:
///
///   theta(t) = psi0 + omega0 t + alpha0 (e^{-a t} - 1 + a t)/a^2 + h(theta) + r(t),
///
/// with psi0, omega0, alpha0 free in each segment (so that friction may differ from run to run without
/// biasing a), a common damping a, the sensors' angle error h as a Fourier series, and the response r of the
/// rotor to torque and friction ripple and to the loss of torque at speed. Variable projection: the linear
/// unknowns are eliminated exactly, a is found by Gauss-Newton. Covariance of a by the sandwich over
/// segments (CR2). Cost: samples times unknowns^2. Errors: Refused (no segment; the segments do not bend, so
/// that a is undecided), NotFinite, that of checkAbort. Source: resources/help/identification.md section 3.
Result<MotionFit> fitMotion(std::span<const MotionSegment> segments, const MotionFitConfig& config = {});

/// The measured angle without the sensors' error that the fit found.
std::vector<double> correctedAngle_rad(const MotionFit& fit, std::span<const double> angle_rad);

/// Straight line through the balances: phi/J, K_f/J of both directions and their joint covariance with a.
struct BalanceFit {
    std::optional<double> torque_rad_s2_A; ///< k = phi/J; absent without two different currents
    std::optional<double> friction_rad_s2; ///< f = K_f/J, mean of the directions seen
    std::optional<double> frictionForward_rad_s2;
    std::optional<double> frictionReverse_rad_s2;
    std::optional<double> asymmetry; ///< (K_f+ - K_f-)/(K_f+ + K_f-)
    double asymmetryError = 0.0;
    Eigen::Matrix3d scatterCovariance = Eigen::Matrix3d::Zero(); ///< of (a, f, k) from run-to-run friction
    /// of (a, f, k) from the error of a and what else all segments share
    Eigen::Matrix3d dampingCovariance = Eigen::Matrix3d::Zero();
    int freedom = 0;
    double scatter_rad_s2 = 0.0;   ///< run-to-run friction over J, 1 sigma
    bool isScatterAssumed = false; ///< no stretch is left over to show it
    Eigen::MatrixXd design;        ///< columns s I (when k is decided), -1 per direction
    Eigen::VectorXd observed;
    Eigen::VectorXd weights;
    Eigen::VectorXd residuals;
};

/// As many stretches as unknowns leave nothing to see the scatter of friction by: 3.3 % of the largest torque
/// that friction may be is taken then (resources/help/htm-theory.md section 9).
/// Errors: Refused when the balances decide neither friction nor torque constant (run-ups at one current).
Result<BalanceFit> fitBalance(const MotionFit& motion);

} // namespace halbench::control
