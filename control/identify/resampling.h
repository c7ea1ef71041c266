#pragma once

#include "control/identify/least_squares.h"

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace halbench::control {

/// What is computed from the coefficients of a fit, e.g. (c, K_f) from slope and intercept.
using FitQuantity = std::function<Eigen::VectorXd(const Eigen::VectorXd& coefficients)>;

struct BootstrapResult {
    std::vector<std::pair<double, double>> interval95; ///< percentile interval of each quantity
    int draws = 0;                                     ///< resamples that could be fitted
    int refused = 0;                                   ///< resamples that did not decide the coefficients
};

/// Pairs bootstrap: rows are drawn with replacement, the weighted fit repeated. Deterministic for a seed.
/// Errors: Refused when more than one resample in ten cannot be fitted.
Result<BootstrapResult> bootstrapPairs(const Eigen::MatrixXd& design, const Eigen::VectorXd& observed,
                                       const Eigen::VectorXd& weights, const FitQuantity& quantity,
                                       std::uint64_t seed, int resamples = 2000);

/// Change of each quantity when row i is left out, in units of its standard error: row i, column quantity.
/// A row without which the fit is impossible counts as infinite influence.
Eigen::MatrixXd leaveOneOut(const Eigen::MatrixXd& design, const Eigen::VectorXd& observed,
                            const Eigen::VectorXd& weights, const FitQuantity& quantity,
                            const Eigen::VectorXd& standardError);

} // namespace halbench::control
