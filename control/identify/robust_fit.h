#pragma once

#include "control/identify/least_squares.h"

namespace halbench::control {

enum class RobustLoss { Huber, Bisquare };

/// A robust fit beside the ordinary one.
struct RobustFit {
    LinearFit fit;                    ///< with the final weights; covariance after Huber's correction
    LinearFit ordinary;               ///< the same data without robust weights
    Eigen::VectorXd weights;          ///< robustness weight of each row, 0 ... 1
    double scale = 0.0;               ///< robust 1 sigma of an observation of weight 1
    bool differsFromOrdinary = false; ///< a coefficient moved by more than 1 sigma of the ordinary fit
};

/// Iteratively re-weighted least squares. Scale: normalised median of the absolute residuals, corrected for
/// leverage. Tuning for 95 % efficiency at the normal distribution: Huber 1.345, bisquare 4.685 (started from
/// Huber's solution). Errors: as fitLinear.
/// Source: resources/help/identification.md section 2.
Result<RobustFit> fitRobust(const Eigen::MatrixXd& design, const Eigen::VectorXd& observed,
                            const Eigen::VectorXd& weights, RobustLoss loss = RobustLoss::Huber);

} // namespace halbench::control
