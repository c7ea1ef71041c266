#include "control/lti/eigenvalues.h"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace halbench::control {

namespace {

double columnSize(const Eigen::MatrixXd& matrix, Eigen::Index i) {
    return matrix.size() == 0 ? 0.0 : matrix.col(i).cwiseAbs().sum();
}

double rowSize(const Eigen::MatrixXd& matrix, Eigen::Index i) {
    return matrix.size() == 0 ? 0.0 : matrix.row(i).cwiseAbs().sum();
}

} // namespace

Eigen::VectorXd balancingScale(const Eigen::MatrixXd& A, const Eigen::MatrixXd& input,
                               const Eigen::MatrixXd& output) {
    Eigen::MatrixXd a = A;
    Eigen::MatrixXd b = input;
    Eigen::MatrixXd c = output;
    Eigen::VectorXd scale = Eigen::VectorXd::Ones(A.rows());
    constexpr int MostRounds = 100;
    bool isDone = false;
    for (int round = 0; round < MostRounds && !isDone; ++round) {
        isDone = true;
        for (Eigen::Index i = 0; i < A.rows(); ++i) {
            const double column = columnSize(a, i) - std::abs(a(i, i)) + columnSize(c, i);
            const double row = rowSize(a, i) - std::abs(a(i, i)) + rowSize(b, i);
            if (!(column > 0.0 && row > 0.0)) {
                continue;
            }
            const double factor = std::exp2(std::round(0.5 * std::log2(row / column)));
            if (column * factor + row / factor < 0.95 * (column + row)) {
                isDone = false;
                scale(i) *= factor;
                a.col(i) *= factor;
                a.row(i) /= factor;
                if (b.size() > 0) {
                    b.row(i) /= factor;
                }
                if (c.size() > 0) {
                    c.col(i) *= factor;
                }
            }
        }
    }
    return scale;
}

std::vector<std::complex<double>> eigenvalues(const Eigen::MatrixXd& A) {
    if (A.size() == 0) {
        return {};
    }
    const Eigen::VectorXd scale = balancingScale(A);
    const Eigen::MatrixXd balanced = scale.cwiseInverse().asDiagonal() * A * scale.asDiagonal();
    const Eigen::VectorXcd values = Eigen::EigenSolver<Eigen::MatrixXd>(balanced, false).eigenvalues();
    return {values.data(), values.data() + values.size()};
}

std::vector<std::complex<double>> generalizedEigenvalues(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
    std::vector<std::complex<double>> result;
    if (A.size() == 0) {
        return result;
    }
    const Eigen::GeneralizedEigenSolver<Eigen::MatrixXd> solver(A, B, false);
    const double rounding = 1e-14 * B.norm();
    for (Eigen::Index i = 0; i < A.rows(); ++i) {
        if (std::abs(solver.betas()(i)) > rounding) {
            result.push_back(solver.alphas()(i) / solver.betas()(i));
        }
    }
    return result;
}

} // namespace halbench::control
