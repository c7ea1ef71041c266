#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

namespace halbench::control {

/// Diagonal scaling by powers of two that brings the rows and columns of a square matrix to similar size
/// (Parlett, Reinsch 1969): diag(d)^-1 A diag(d). `input` rows and `output` columns, when given, are counted
/// with the matrix. Exact: no digit changes.
Eigen::VectorXd balancingScale(const Eigen::MatrixXd& A, const Eigen::MatrixXd& input = {},
                               const Eigen::MatrixXd& output = {});

/// Eigenvalues of a real matrix, balanced first. Error about rounding x norm of the balanced matrix x
/// condition of the eigenvalue. O(n^3).
std::vector<std::complex<double>> eigenvalues(const Eigen::MatrixXd& A);

/// Finite lambda with det(A - lambda B) = 0, by the QZ algorithm; infinite ones are left out.
std::vector<std::complex<double>> generalizedEigenvalues(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

} // namespace halbench::control
