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

/// Controllable canonical form.
StateSpace toStateSpace(const TransferFunction& system);

/// One input to one output by the Faddeev-LeVerrier recursion; good for the small orders of this program
/// (up to about 10). Error: OutOfRange for an input or output that does not exist.
Result<TransferFunction> toTransferFunction(const StateSpace& system, Eigen::Index output = 0,
                                            Eigen::Index input = 0);

/// Eigenvalues of A.
std::vector<std::complex<double>> poles(const StateSpace& system);

} // namespace halbench::control
