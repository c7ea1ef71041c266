#pragma once

#include "control/base/result.h"
#include "control/lti/transfer_function.h"

#include <Eigen/Core>
#include <complex>
#include <vector>

namespace halbench::control {

/// x' = A x + B u (or x[k+1] = A x[k] + B u[k]),  y = C x + D u.
struct StateSpace {
    Eigen::MatrixXd A;
    Eigen::MatrixXd B;
    Eigen::MatrixXd C;
    Eigen::MatrixXd D;
    TimeBase timeBase = TimeBase::continuous();

    Eigen::Index states() const { return A.rows(); }
    Eigen::Index inputs() const { return B.cols(); }
    Eigen::Index outputs() const { return C.rows(); }
};

/// The one place where sizes and numbers are judged. Errors: InvalidInput (sizes), NotFinite.
Result<StateSpace> makeStateSpace(Eigen::MatrixXd A, Eigen::MatrixXd B, Eigen::MatrixXd C, Eigen::MatrixXd D,
                                  TimeBase timeBase);

/// Controllable canonical form. Badly scaled when rates lie decades apart: see `prescaled`.
StateSpace toStateSpace(const TransferFunction& system);

/// One input to one output. Up to order 8 by the Faddeev-LeVerrier recursion, beyond by way of zeros and
/// poles
/// (`toZeroPoleGain`): a polynomial of high order keeps few digits of its roots however it was found. Error:
/// OutOfRange for an input or output that does not exist.
Result<TransferFunction> toTransferFunction(const StateSpace& system, Eigen::Index output = 0,
                                            Eigen::Index input = 0);

/// first then second, first + second, forward / (1 + forward * back); states in that order. Errors:
/// InvalidInput for mixed time bases, sizes that do not fit, and for an algebraic loop.
Result<StateSpace> series(const StateSpace& first, const StateSpace& second);
Result<StateSpace> parallel(const StateSpace& first, const StateSpace& second);
Result<StateSpace> feedback(const StateSpace& forward, const StateSpace& back);

/// Eigenvalues of A (balanced).
std::vector<std::complex<double>> poles(const StateSpace& system);

/// Gain from each input to each output for constant input: D - C A^-1 B, sampled D + C (1 - A)^-1 B. Infinite
/// for all paths when the system integrates.
Eigen::MatrixXd dcGain(const StateSpace& system);

} // namespace halbench::control
