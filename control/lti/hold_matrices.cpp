#include "control/lti/hold_matrices.h"

#include "control/lti/eigenvalues.h"

#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

namespace halbench::control {

HeldInput heldInput(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B, double period_s) {
    const Eigen::Index n = A.rows();
    const Eigen::Index m = B.cols();
    Eigen::MatrixXd block = Eigen::MatrixXd::Zero(n + 2 * m, n + 2 * m);
    block.topLeftCorner(n, n) = A * period_s;
    block.block(0, n, n, m) = B * period_s;
    block.block(n, n + m, m, m) = Eigen::MatrixXd::Identity(m, m);
    const Eigen::MatrixXd e = block.exp();
    return {e.topLeftCorner(n, n), e.block(0, n, n, m), e.block(0, n + m, n, m)};
}

std::optional<Eigen::MatrixXd> matrixLogarithm(const Eigen::MatrixXd& matrix) {
    for (const auto& value : eigenvalues(matrix)) {
        const bool isOnAxis = std::abs(value.imag()) <= 1e-12 * std::abs(value);
        if (std::abs(value) < 1e-12 || (isOnAxis && value.real() < 0.0)) {
            return std::nullopt;
        }
    }
    Eigen::MatrixXd logarithm = matrix.log();
    if (!logarithm.allFinite()) {
        return std::nullopt;
    }
    return logarithm;
}

} // namespace halbench::control
