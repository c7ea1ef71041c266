#pragma once

#include "control/base/result.h"

#include <Eigen/Core>

namespace halbench::control {

/// Stabilising solution of X = A'XA - A'XB (R + B'XB)^-1 B'XA + Q, by the structure-preserving doubling
/// algorithm (Chu, Fan, Lin, Wang 2004): quadratic convergence, O(n^3) a round. Errors: InvalidInput (sizes,
/// R not positive definite), Refused (no stabilising solution: a pole on or outside the unit circle is not
/// reached by the input, or one on it not seen by Q).
Result<Eigen::MatrixXd> solveRiccati(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B,
                                     const Eigen::MatrixXd& Q, const Eigen::MatrixXd& R);

/// u = -K x that minimises sum x'Qx + u'Ru: K = (R + B'XB)^-1 B'XA. Errors as above.
Result<Eigen::MatrixXd> regulatorGain(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B,
                                      const Eigen::MatrixXd& Q, const Eigen::MatrixXd& R);

/// X = A X A' + Q for a stable A, by doubling (Smith 1968). The covariance that noise of covariance Q leaves.
Eigen::MatrixXd solveLyapunov(const Eigen::MatrixXd& A, const Eigen::MatrixXd& Q);

} // namespace halbench::control
