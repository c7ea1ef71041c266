#include "control/lti/riccati.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>

namespace halbench::control {

using Eigen::MatrixXd;

Result<MatrixXd> solveRiccati(const MatrixXd& A, const MatrixXd& B, const MatrixXd& Q, const MatrixXd& R) {
    const Eigen::Index n = A.rows();
    const bool fits = A.cols() == n && B.rows() == n && Q.rows() == n && Q.cols() == n &&
                      R.rows() == B.cols() && R.cols() == B.cols();
    if (!fits || R.llt().info() != Eigen::Success) {
        return failure(ErrorCode::InvalidInput, "the weights of the regulator do not fit the system");
    }
    MatrixXd a = A;
    MatrixXd G = B * R.llt().solve(B.transpose());
    MatrixXd H = Q;
    constexpr int MostRounds = 60;
    for (int round = 0; round < MostRounds; ++round) {
        const Eigen::PartialPivLU<MatrixXd> W(MatrixXd::Identity(n, n) + G * H);
        const MatrixXd solvedA = W.solve(a);
        const MatrixXd solvedG = W.solve(G);
        const MatrixXd growth = a.transpose() * H * solvedA;
        G += a * solvedG * a.transpose();
        H += growth;
        a = (a * solvedA).eval();
        if (!H.allFinite() || growth.norm() <= 1e-15 * H.norm()) {
            break;
        }
    }
    if (!H.allFinite() || !(a.norm() < 1e-3)) {
        return failure(ErrorCode::Refused, "no regulator stabilises this system with these weights",
                       "weight every state that does not decay by itself");
    }
    return MatrixXd(0.5 * (H + H.transpose()));
}

Result<MatrixXd> regulatorGain(const MatrixXd& A, const MatrixXd& B, const MatrixXd& Q, const MatrixXd& R) {
    const auto X = solveRiccati(A, B, Q, R);
    if (!X) {
        return failure(X.error());
    }
    const MatrixXd weight = R + B.transpose() * *X * B;
    return MatrixXd(weight.llt().solve(B.transpose() * *X * A));
}

MatrixXd solveLyapunov(const MatrixXd& A, const MatrixXd& Q) {
    MatrixXd a = A;
    MatrixXd X = Q;
    constexpr int MostRounds = 60;
    for (int round = 0; round < MostRounds; ++round) {
        const MatrixXd growth = a * X * a.transpose();
        X += growth;
        a = (a * a).eval();
        if (!X.allFinite() || growth.norm() <= 1e-16 * X.norm()) {
            break;
        }
    }
    return X;
}

} // namespace halbench::control
