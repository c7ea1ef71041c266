#pragma once

#include "control/identify/least_squares.h"

namespace halbench::control {

/// A linear fit in which every point has its known measuring variance plus one unknown scatter common to all.
struct ScatterFit {
    LinearFit fit;           ///< covariance: residual variance times (X' W X)^-1, Student t with `freedom`
    Eigen::VectorXd weights; ///< 1/(common + measuring variance)
    double commonVariance = 0.0; ///< run-to-run scatter, measuring noise taken off; at least 0
};

/// Weights from the measuring variance of each point plus the common scatter (on this machine the friction,
/// which differs from run to run), found by iterating the moment estimate
///   sum w r^2 = n - p  with  w = 1/(common + measuring).
/// The interval follows from the residuals, so it stays honest whatever the split between the two.
/// Errors: as fitLinear. Source: resources/help/identification.md section 2.
Result<ScatterFit> fitWithScatter(const Eigen::MatrixXd& design, const Eigen::VectorXd& observed,
                                  const Eigen::VectorXd& measuringVariance);

} // namespace halbench::control
