#include "control/lti/state_space.h"

#include "control/lti/eigenvalues.h"
#include "control/lti/zero_pole_gain.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <limits>

namespace halbench::control {

namespace {

StateSpace zeroSystem(Eigen::Index states, Eigen::Index inputs, Eigen::Index outputs, TimeBase base) {
    return {Eigen::MatrixXd::Zero(states, states), Eigen::MatrixXd::Zero(states, inputs),
            Eigen::MatrixXd::Zero(outputs, states), Eigen::MatrixXd::Zero(outputs, inputs), base};
}

tl::unexpected<Error> doNotFit(Eigen::Index signals, Eigen::Index places) {
    return failure(ErrorCode::InvalidInput,
                   fmt::format("systems with {} and {} signals cannot be connected", signals, places));
}

} // namespace

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
    constexpr Eigen::Index MostStates = 8;
    if (n > MostStates) {
        const auto factors = toZeroPoleGain(system, output, input);
        return factors ? toTransferFunction(*factors) : failure(factors.error());
    }
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

Result<StateSpace> series(const StateSpace& first, const StateSpace& second) {
    const auto base = commonTimeBase(first.timeBase, second.timeBase);
    if (!base) {
        return failure(base.error());
    }
    if (second.inputs() != first.outputs()) {
        return doNotFit(first.outputs(), second.inputs());
    }
    const Eigen::Index n1 = first.states();
    const Eigen::Index n2 = second.states();
    StateSpace result = zeroSystem(n1 + n2, first.inputs(), second.outputs(), *base);
    result.A.topLeftCorner(n1, n1) = first.A;
    result.A.bottomLeftCorner(n2, n1) = second.B * first.C;
    result.A.bottomRightCorner(n2, n2) = second.A;
    result.B.topRows(n1) = first.B;
    result.B.bottomRows(n2) = second.B * first.D;
    result.C.leftCols(n1) = second.D * first.C;
    result.C.rightCols(n2) = second.C;
    result.D = second.D * first.D;
    return result;
}

Result<StateSpace> parallel(const StateSpace& first, const StateSpace& second) {
    const auto base = commonTimeBase(first.timeBase, second.timeBase);
    if (!base) {
        return failure(base.error());
    }
    if (first.inputs() != second.inputs() || first.outputs() != second.outputs()) {
        return doNotFit(first.outputs() * first.inputs(), second.outputs() * second.inputs());
    }
    const Eigen::Index n1 = first.states();
    const Eigen::Index n2 = second.states();
    StateSpace result = zeroSystem(n1 + n2, first.inputs(), first.outputs(), *base);
    result.A.topLeftCorner(n1, n1) = first.A;
    result.A.bottomRightCorner(n2, n2) = second.A;
    result.B << first.B, second.B;
    result.C << first.C, second.C;
    result.D = first.D + second.D;
    return result;
}

// u1 = r - y2, y1 = C1 x1 + D1 u1, y2 = C2 x2 + D2 y1, solved for y1 with W = (1 + D1 D2)^-1
Result<StateSpace> feedback(const StateSpace& forward, const StateSpace& back) {
    const auto base = commonTimeBase(forward.timeBase, back.timeBase);
    if (!base) {
        return failure(base.error());
    }
    if (forward.outputs() != back.inputs() || forward.inputs() != back.outputs()) {
        return doNotFit(forward.outputs(), back.inputs());
    }
    const Eigen::MatrixXd direct =
        Eigen::MatrixXd::Identity(forward.outputs(), forward.outputs()) + forward.D * back.D;
    const Eigen::FullPivLU<Eigen::MatrixXd> lu(direct);
    if (!lu.isInvertible()) {
        return failure(ErrorCode::InvalidInput, "the feedback closes an algebraic loop with 1 + L = 0",
                       "an algebraic loop: one of the two systems needs a delay");
    }
    const Eigen::MatrixXd W = lu.inverse();
    const Eigen::Index n1 = forward.states();
    const Eigen::Index n2 = back.states();
    StateSpace result = zeroSystem(n1 + n2, forward.inputs(), forward.outputs(), *base);
    result.C << W * forward.C, -W * forward.D * back.C;
    result.D = W * forward.D;
    // What x1 and x2 see of the states: u1 = r - C2 x2 - D2 y1, u2 = y1.
    Eigen::MatrixXd u1 = -back.D * result.C;
    u1.rightCols(n2) -= back.C;
    result.A.topRows(n1) = forward.B * u1;
    result.A.topLeftCorner(n1, n1) += forward.A;
    result.A.bottomRows(n2) = back.B * result.C;
    result.A.bottomRightCorner(n2, n2) += back.A;
    result.B << forward.B - forward.B * back.D * result.D, back.B * result.D;
    return result;
}

std::vector<std::complex<double>> poles(const StateSpace& system) {
    return eigenvalues(system.A);
}

Eigen::MatrixXd dcGain(const StateSpace& system) {
    const Eigen::Index n = system.states();
    if (n == 0) {
        return system.D;
    }
    const double rest = system.timeBase.isContinuous() ? 0.0 : 1.0;
    const Eigen::MatrixXd held = rest * Eigen::MatrixXd::Identity(n, n) - system.A;
    const Eigen::FullPivLU<Eigen::MatrixXd> lu(held);
    if (!lu.isInvertible()) {
        return Eigen::MatrixXd::Constant(system.outputs(), system.inputs(),
                                         std::numeric_limits<double>::infinity());
    }
    return system.D + system.C * lu.solve(system.B);
}

} // namespace halbench::control
