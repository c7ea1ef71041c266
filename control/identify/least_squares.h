#pragma once

#include "control/base/result.h"

#include <Eigen/Core>
#include <span>

namespace halbench::control {

/// Solution of min |sqrt(W) (y - X b)|^2.
struct LinearFit {
    Eigen::VectorXd coefficients;
    Eigen::MatrixXd covariance;  ///< s^2 (X' W X)^-1 with s^2 = sum w r^2 / (n - p)
    Eigen::MatrixXd unscaled;    ///< (X' W X)^-1, for a known variance
    Eigen::VectorXd residuals;   ///< y - X b, not weighted
    Eigen::VectorXd leverage;    ///< diagonal of the hat matrix
    double residualVariance = 0; ///< s^2, variance of an observation of weight 1; 0 when n = p
    int freedom = 0;             ///< n - p
};

/// Weighted linear least squares by Householder QR with column pivoting; columns are scaled first, so that
/// units do not decide the rank. Weights are inverse variances up to a common factor; zero leaves a row out.
/// Errors: NotFinite; Refused when fewer usable rows than columns or when the columns do not carry enough
/// information to tell the coefficients apart (relative rank tolerance 1e-10).
/// Source: resources/help/identification.md section 2.
Result<LinearFit> fitLinear(const Eigen::MatrixXd& design, const Eigen::VectorXd& observed,
                            const Eigen::VectorXd& weights);
/// All weights 1.
Result<LinearFit> fitLinear(const Eigen::MatrixXd& design, const Eigen::VectorXd& observed);

/// 1 - sum w r^2 / sum w (y - mean)^2.
double rSquared(const LinearFit& fit, const Eigen::VectorXd& observed, const Eigen::VectorXd& weights);

/// Arithmetic mean; there must be a value.
double mean(std::span<const double> values);

} // namespace halbench::control
