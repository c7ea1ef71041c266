#include "control/lti/state_space.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>

namespace halbench::control {

Result<StateSpace> makeStateSpace(Eigen::MatrixXd A, Eigen::MatrixXd B, Eigen::MatrixXd C, Eigen::MatrixXd D,
                                  TimeBase timeBase) {
    const bool fits = A.rows() == A.cols() && B.rows() == A.rows() && C.cols() == A.rows() &&
                      D.rows() == C.rows() && D.cols() == B.cols() && B.cols() > 0 && C.rows() > 0;
    if (!fits) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("state space matrices do not fit: A {}x{}, B {}x{}, C {}x{}, D {}x{}",
                                   A.rows(), A.cols(), B.rows(), B.cols(), C.rows(), C.cols(), D.rows(),
                                   D.cols()));
    }
    if (!A.allFinite() || !B.allFinite() || !C.allFinite() || !D.allFinite()) {
        return failure(ErrorCode::NotFinite, "a state space matrix holds a value that is not finite");
    }
    return StateSpace{std::move(A), std::move(B), std::move(C), std::move(D), timeBase};
}

StateSpace toStateSpace(const TransferFunction& system) {
    const Polynomial& denominator = system.denominator();
    const Eigen::Index n = system.order();
    Polynomial numerator(static_cast<std::size_t>(n) + 1 - system.numerator().size(), 0.0);
    numerator.insert(numerator.end(), system.numerator().begin(), system.numerator().end());

    StateSpace result{Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, 1), Eigen::MatrixXd::Zero(1, n),
                      Eigen::MatrixXd::Zero(1, 1), system.timeBase()};
    const double leading = denominator.front();
    const double direct = numerator.front() / leading;
    result.D(0, 0) = direct;
    for (Eigen::Index i = 0; i < n; ++i) {
        const auto at = static_cast<std::size_t>(i) + 1;
        result.A(0, i) = -denominator[at] / leading;
        result.C(0, i) = numerator[at] / leading - direct * denominator[at] / leading;
        if (i > 0) {
            result.A(i, i - 1) = 1.0;
        }
    }
    if (n > 0) {
        result.B(0, 0) = 1.0;
    }
    return result;
}

Result<TransferFunction> toTransferFunction(const StateSpace& system, Eigen::Index output,
                                            Eigen::Index input) {
    if (output < 0 || output >= system.outputs() || input < 0 || input >= system.inputs()) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("there is no path from input {} to output {}", input, output));
    }
    const Eigen::Index n = system.states();
    const Eigen::RowVectorXd c = system.C.row(output);
    const Eigen::VectorXd b = system.B.col(input);
    const double d = system.D(output, input);
    // adj(sI - A) = sum R_k s^(n-1-k);  R_0 = I, R_k = A R_(k-1) + p_k I, p_k = -trace(A R_(k-1))/k
    Polynomial denominator = {1.0};
    Polynomial numerator = {d};
    Eigen::MatrixXd R = Eigen::MatrixXd::Identity(n, n);
    for (Eigen::Index k = 1; k <= n; ++k) {
        const double path = (c * R * b).value();
        const Eigen::MatrixXd AR = system.A * R;
        const double coefficient = -AR.trace() / static_cast<double>(k);
        denominator.push_back(coefficient);
        numerator.push_back(path + d * coefficient);
        R = AR + coefficient * Eigen::MatrixXd::Identity(n, n);
    }
    return TransferFunction::make(std::move(numerator), std::move(denominator), system.timeBase);
}

std::vector<std::complex<double>> poles(const StateSpace& system) {
    const Eigen::VectorXcd values = Eigen::EigenSolver<Eigen::MatrixXd>(system.A, false).eigenvalues();
    return {values.data(), values.data() + values.size()};
}

} // namespace halbench::control
