#include "control/lti/discretize.h"

#include "control/base/units.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

namespace halbench::control {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// exp([A B; 0 0] T) = [Phi Gamma; 0 I]
StateSpace holdZero(const StateSpace& system, double period_s) {
    const Index n = system.states();
    const Index m = system.inputs();
    MatrixXd block = MatrixXd::Zero(n + m, n + m);
    block.topLeftCorner(n, n) = system.A * period_s;
    block.topRightCorner(n, m) = system.B * period_s;
    const MatrixXd e = block.exp();
    return {e.topLeftCorner(n, n), e.topRightCorner(n, m), system.C, system.D, TimeBase::sampled(period_s)};
}

/// exp([A T, B T, 0; 0 0 I; 0 0 0]) = [Phi Gamma1 Gamma2; ...], state shifted by Gamma2 u.
StateSpace holdFirst(const StateSpace& system, double period_s) {
    const Index n = system.states();
    const Index m = system.inputs();
    MatrixXd block = MatrixXd::Zero(n + 2 * m, n + 2 * m);
    block.topLeftCorner(n, n) = system.A * period_s;
    block.block(0, n, n, m) = system.B * period_s;
    block.block(n, n + m, m, m) = MatrixXd::Identity(m, m);
    const MatrixXd e = block.exp();
    const MatrixXd phi = e.topLeftCorner(n, n);
    const MatrixXd gamma1 = e.block(0, n, n, m);
    const MatrixXd gamma2 = e.block(0, n + m, n, m);
    return {phi, gamma1 + phi * gamma2 - gamma2, system.C, system.D + system.C * gamma2,
            TimeBase::sampled(period_s)};
}

/// `effective_s` is the period stretched by the pre-warping: 2 tan(w T/2)/w.
StateSpace tustin(const StateSpace& system, double period_s, double effective_s) {
    const MatrixXd identity = MatrixXd::Identity(system.states(), system.states());
    const MatrixXd inverse = (identity - 0.5 * effective_s * system.A).inverse();
    const MatrixXd B = inverse * system.B * effective_s;
    return {inverse * (identity + 0.5 * effective_s * system.A), B, system.C * inverse,
            system.D + 0.5 * system.C * B, TimeBase::sampled(period_s)};
}

Result<double> effectivePeriod_s(const Hold::Tustin& method, double period_s) {
    if (!method.prewarp_rad_s) {
        return period_s;
    }
    const double frequency_rad_s = *method.prewarp_rad_s;
    if (!(frequency_rad_s > 0.0 && frequency_rad_s * period_s < Pi)) {
        return failure(
            ErrorCode::OutOfRange,
            fmt::format("the pre-warp frequency of {} rad/s is not between 0 and the Nyquist frequency of "
                        "{:.6g} rad/s",
                        frequency_rad_s, Pi / period_s));
    }
    return 2.0 * std::tan(0.5 * frequency_rad_s * period_s) / frequency_rad_s;
}

} // namespace

Result<StateSpace> discretize(const StateSpace& system, double period_s, const HoldMethod& hold) {
    if (system.timeBase.isSampled()) {
        return failure(ErrorCode::InvalidInput, "the system is already sampled");
    }
    if (const auto base = TimeBase::sampledChecked(period_s); !base) {
        return failure(base.error());
    }
    if (std::holds_alternative<Hold::Zoh>(hold)) {
        return holdZero(system, period_s);
    }
    if (std::holds_alternative<Hold::Foh>(hold)) {
        return holdFirst(system, period_s);
    }
    const auto effective_s = effectivePeriod_s(std::get<Hold::Tustin>(hold), period_s);
    if (!effective_s) {
        return failure(effective_s.error());
    }
    StateSpace result = tustin(system, period_s, *effective_s);
    if (!result.A.allFinite()) {
        return failure(ErrorCode::InvalidInput, "the bilinear rule has no solution: a pole lies at 2/T",
                       "choose a shorter period");
    }
    return result;
}

Result<TransferFunction> discretize(const TransferFunction& system, double period_s, const HoldMethod& hold) {
    if (system.timeBase().isSampled()) {
        return failure(ErrorCode::InvalidInput, "the transfer function is already sampled");
    }
    const auto sampled = discretize(toStateSpace(system), period_s, hold);
    if (!sampled) {
        return failure(sampled.error());
    }
    return toTransferFunction(*sampled);
}

} // namespace halbench::control
