#pragma once

#include "control/base/result.h"

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

namespace halbench::control {

/// One run-up or coast-down under constant current.
struct TransientRecord {
    std::vector<double> time_s; ///< from the record's first sample on
    std::vector<double> angle_rad;
    double current_A = 0.0; ///< signed
    int direction = 1;      ///< of the motion
    bool startsAtRest = false;
};

struct TransientFit {
    double damping_per_s = 0.0;            ///< a = c/J
    double friction_rad_s2 = 0.0;          ///< f = K_f/J
    std::optional<double> torque_rad_s2_A; ///< k = phi/J; absent when every record coasts
    Eigen::MatrixXd covariance;            ///< of (a, f) or (a, f, k)
    double angleNoise_rad = 0.0;
};

/// Fits the exact motion, its end included, to the angle of all records at once:
///   psi(t) = psi0 + omega0 t + (k I - s f - a omega0) (e^{-a t} - 1 + a t)/a^2   until omega = 0, then
///   constant,
/// with one a, f, k for all and psi0, omega0 for each record; Levenberg and Marquardt. One friction for all
/// records: where friction differs from run to run, fitMotion() is the honest fit. Errors: Refused (run-ups
/// at one current decide c/J and phi I - K_f only, records that do not bend), NotFinite. Source:
/// resources/help/identification.md section 3.
Result<TransientFit> fitTransients(std::span<const TransientRecord> records);

} // namespace halbench::control
