#include "control/lti/realization.h"

#include "control/base/assert.h"
#include "control/lti/eigenvalues.h"

#include <Eigen/QR>
#include <cmath>
#include <limits>

namespace halbench::control {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

double sizeOf(const StateSpace& system) {
    return std::sqrt(system.A.squaredNorm() + system.B.squaredNorm() + system.C.squaredNorm());
}

/// States that the input reaches, in orthogonal coordinates; the rest is cut off.
StateSpace reachable(StateSpace system, double negligible) {
    const Index n = system.states();
    Index found = 0;
    MatrixXd block = system.B;
    while (found < n) {
        Eigen::ColPivHouseholderQR<MatrixXd> qr(block);
        Index rank = 0;
        for (Index i = 0; i < std::min(block.rows(), block.cols()); ++i) {
            rank += std::abs(qr.matrixR()(i, i)) > negligible ? 1 : 0;
        }
        if (rank == 0) {
            break;
        }
        const Index rest = n - found;
        MatrixXd turn = MatrixXd::Identity(n, n);
        turn.bottomRightCorner(rest, rest) = MatrixXd(qr.householderQ());
        system.A = turn.transpose() * system.A * turn;
        system.B = turn.transpose() * system.B;
        system.C = system.C * turn;
        block = system.A.block(found + rank, found, rest - rank, rank);
        found += rank;
    }
    return {system.A.topLeftCorner(found, found), system.B.topRows(found), system.C.leftCols(found), system.D,
            system.timeBase};
}

StateSpace mirrored(const StateSpace& system) {
    return {system.A.transpose(), system.C.transpose(), system.B.transpose(), system.D.transpose(),
            system.timeBase};
}

/// x' = A x + b u, y = c x + d u, one input and one output.
struct Path {
    MatrixXd A;
    VectorXd b;
    VectorXd c;
    double d = 0.0;
};

/// With y = 0 the last state, after turning c onto it, is zero for ever; its equation is the new output.
/// Returns the factor between the old output's derivative and the new output.
double holdOutput(Path& path) {
    const Index n = path.A.rows();
    const double length = path.c.norm();
    VectorXd mirror = path.c; // Householder: c onto the last axis
    const double sign = path.c(n - 1) < 0.0 ? -1.0 : 1.0;
    mirror(n - 1) += sign * length;
    mirror.normalize();
    path.A -= 2.0 * mirror * (mirror.transpose() * path.A).eval();
    path.A -= 2.0 * (path.A * mirror).eval() * mirror.transpose();
    path.b -= 2.0 * mirror * mirror.dot(path.b);
    const VectorXd output = path.A.row(n - 1).head(n - 1).transpose();
    path.d = path.b(n - 1);
    path.A = path.A.topLeftCorner(n - 1, n - 1).eval();
    path.b = path.b.head(n - 1).eval();
    path.c = output;
    return -sign * length;
}

/// Finite eigenvalues of [A - s, b; c, d] with d != 0: [c d] is turned onto the last column and cut off.
std::vector<std::complex<double>> pencilZeros(const Path& path) {
    const Index n = path.A.rows();
    MatrixXd M(n, n + 1);
    M << path.A, path.b;
    MatrixXd N = MatrixXd::Identity(n, n + 1);
    VectorXd mirror(n + 1);
    mirror << path.c, path.d;
    mirror(n) += (path.d < 0.0 ? -1.0 : 1.0) * mirror.norm();
    mirror.normalize();
    M -= 2.0 * (M * mirror).eval() * mirror.transpose();
    N -= 2.0 * (N * mirror).eval() * mirror.transpose();
    return generalizedEigenvalues(M.leftCols(n), N.leftCols(n));
}

} // namespace

StateSpace prescaled(const StateSpace& system) {
    const VectorXd scale = balancingScale(system.A, system.B, system.C);
    const VectorXd inverse = scale.cwiseInverse();
    return {inverse.asDiagonal() * system.A * scale.asDiagonal(), inverse.asDiagonal() * system.B,
            system.C * scale.asDiagonal(), system.D, system.timeBase};
}

StateSpace minimalRealization(const StateSpace& system, double tolerance_ratio) {
    const StateSpace scaled = prescaled(system);
    const double negligible = tolerance_ratio * sizeOf(scaled);
    const StateSpace reached = reachable(scaled, negligible);
    return mirrored(reachable(mirrored(reached), negligible));
}

PathZeros pathZeros(const StateSpace& system, Eigen::Index output, Eigen::Index input) {
    HB_ASSERT(output >= 0 && output < system.outputs() && input >= 0 && input < system.inputs());
    StateSpace one{system.A, system.B.col(input), system.C.row(output), MatrixXd::Zero(1, 1),
                   system.timeBase};
    one = prescaled(one);
    Path path{one.A, one.B.col(0), one.C.row(0).transpose(), system.D(output, input)};
    const double rounding =
        std::numeric_limits<double>::epsilon() * 10.0 * static_cast<double>(system.states() + 1);
    const double inputSize = one.B.norm();
    const double stateSize = one.A.norm();
    PathZeros result;
    double gain = 1.0;
    bool isGiven = true; // D was given; what the reduction finds carries the rounding of A and B
    while (std::abs(path.d) <= (isGiven ? 0.0 : rounding * inputSize)) {
        if (path.A.rows() == 0 || path.c.norm() <= (isGiven ? 0.0 : rounding * stateSize)) {
            return result;
        }
        gain *= holdOutput(path);
        isGiven = false;
    }
    result.gain = gain * path.d;
    result.zeros = pencilZeros(path);
    return result;
}

std::vector<std::complex<double>> zeros(const StateSpace& system, Eigen::Index output, Eigen::Index input) {
    return pathZeros(system, output, input).zeros;
}

} // namespace halbench::control
