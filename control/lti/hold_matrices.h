#pragma once

#include <Eigen/Core>
#include <optional>

namespace halbench::control {

/// What x' = A x + B u does over an interval T when u runs straight from u0 to u1:
///   x(T) = transition x(0) + constant u0 + slope (u1 - u0)
/// from one exponential, exp([A T, B T, 0; 0, 0, 1; 0, 0, 0]) (Franklin, Powell, Workman, section 4.3; Van
/// Loan 1978). Scaling and squaring with Pade: error about 1e-15 of the exponential's norm.
struct HeldInput {
    Eigen::MatrixXd transition; ///< exp(A T)
    Eigen::MatrixXd constant;
    Eigen::MatrixXd slope;
};
HeldInput heldInput(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B, double period_s);

/// Principal logarithm of a real matrix; absent when an eigenvalue is zero or lies on the negative real axis.
std::optional<Eigen::MatrixXd> matrixLogarithm(const Eigen::MatrixXd& matrix);

} // namespace halbench::control
