#include "control/lti/discretize.h"

#include "control/base/units.h"
#include "control/lti/hold_matrices.h"
#include "control/lti/matched_roots.h"
#include "control/lti/realization.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <cmath>

namespace halbench::control {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

StateSpace holdZero(const StateSpace& system, double period_s) {
    const HeldInput held = heldInput(system.A, system.B, period_s);
    return {held.transition, held.constant, system.C, system.D, TimeBase::sampled(period_s)};
}

/// The state shifted by the share of the input that its slope has already brought.
StateSpace holdFirst(const StateSpace& system, double period_s) {
    const HeldInput held = heldInput(system.A, system.B, period_s);
    return {held.transition, held.constant + held.transition * held.slope - held.slope, system.C,
            system.D + system.C * held.slope, TimeBase::sampled(period_s)};
}

/// h[k] = T C Phi^k B
Result<StateSpace> keepImpulse(const StateSpace& system, double period_s) {
    if (!system.D.isZero(0.0)) {
        return failure(ErrorCode::InvalidInput, "the impulse response of this system begins with an impulse",
                       "choose another rule, or add the filter that every real system has");
    }
    const HeldInput held = heldInput(system.A, system.B, period_s);
    return StateSpace{held.transition, period_s * held.transition * system.B, system.C,
                      period_s * system.C * system.B, TimeBase::sampled(period_s)};
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

Result<StateSpace> bilinear(const StateSpace& system, double period_s, const Hold::Tustin& method) {
    const auto effective_s = effectivePeriod_s(method, period_s);
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

// ---- and back

tl::unexpected<Error> noContinuousImage() {
    return failure(
        ErrorCode::Refused, "this sampled system does not correspond to a continuous one",
        "a pole lies at zero or on the negative real axis: choose Tustin, or take delays out first");
}

/// A = (2/T)(Phi - 1)(Phi + 1)^-1, and what follows for the rest.
Result<StateSpace> inverseBilinear(const StateSpace& sampled, const Hold::Tustin& method) {
    const auto effective_s = effectivePeriod_s(method, sampled.timeBase.period_s());
    if (!effective_s) {
        return failure(effective_s.error());
    }
    const MatrixXd identity = MatrixXd::Identity(sampled.states(), sampled.states());
    const Eigen::FullPivLU<MatrixXd> lu(sampled.A + identity);
    if (!lu.isInvertible()) {
        return noContinuousImage();
    }
    const MatrixXd A = 2.0 / *effective_s * lu.solve(sampled.A - identity);
    const MatrixXd back = identity - 0.5 * *effective_s * A;
    const MatrixXd C = sampled.C * back;
    return StateSpace{A, back * sampled.B / *effective_s, C, sampled.D - 0.5 * C * sampled.B,
                      TimeBase::continuous()};
}

Result<StateSpace> inverseImpulse(const StateSpace& sampled, const MatrixXd& A) {
    const double period_s = sampled.timeBase.period_s();
    const MatrixXd B = sampled.A.fullPivLu().solve(sampled.B) / period_s;
    const MatrixXd jump = period_s * sampled.C * B;
    if ((jump - sampled.D).norm() > 1e-9 * period_s * sampled.C.norm() * B.norm()) {
        return noContinuousImage();
    }
    return StateSpace{A, B, sampled.C, MatrixXd::Zero(sampled.outputs(), sampled.inputs()),
                      TimeBase::continuous()};
}

/// With A known, the input acts through the same integrals as on the way there.
Result<StateSpace> inverseHold(const StateSpace& sampled, const HoldMethod& hold) {
    const double period_s = sampled.timeBase.period_s();
    const auto A = matrixLogarithm(sampled.A);
    if (!A) {
        return noContinuousImage();
    }
    const MatrixXd rates = *A / period_s;
    if (std::holds_alternative<Hold::Impulse>(hold)) {
        return inverseImpulse(sampled, rates);
    }
    const Index n = sampled.states();
    const HeldInput held = heldInput(rates, MatrixXd::Identity(n, n), period_s);
    const bool isStraight = std::holds_alternative<Hold::Foh>(hold);
    const MatrixXd slope = (isStraight ? 1.0 : 0.0) * held.slope;
    const MatrixXd B = MatrixXd(held.constant + held.transition * slope - slope).fullPivLu().solve(sampled.B);
    return StateSpace{rates, B, sampled.C, sampled.D - sampled.C * slope * B, TimeBase::continuous()};
}

bool isSinglePath(const StateSpace& system) {
    return system.inputs() == 1 && system.outputs() == 1;
}

tl::unexpected<Error> severalPaths() {
    return failure(ErrorCode::InvalidInput,
                   "poles and zeros can only be matched for one input and one output");
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
    if (std::holds_alternative<Hold::Impulse>(hold)) {
        return keepImpulse(system, period_s);
    }
    if (std::holds_alternative<Hold::Matched>(hold)) {
        if (!isSinglePath(system)) {
            return severalPaths();
        }
        const auto factors = toZeroPoleGain(system);
        const auto matched = factors ? matchedSampled(*factors, period_s) : factors;
        return matched ? Result<StateSpace>(toStateSpace(*matched)) : failure(matched.error());
    }
    return bilinear(system, period_s, std::get<Hold::Tustin>(hold));
}

Result<TransferFunction> discretize(const TransferFunction& system, double period_s, const HoldMethod& hold) {
    if (system.timeBase().isSampled()) {
        return failure(ErrorCode::InvalidInput, "the transfer function is already sampled");
    }
    const auto sampled = discretize(prescaled(toStateSpace(system)), period_s, hold);
    if (!sampled) {
        return failure(sampled.error());
    }
    return toTransferFunction(*sampled);
}

Result<StateSpace> toContinuous(const StateSpace& sampled, const HoldMethod& hold) {
    if (sampled.timeBase.isContinuous()) {
        return failure(ErrorCode::InvalidInput, "the system is already continuous");
    }
    if (std::holds_alternative<Hold::Tustin>(hold)) {
        return inverseBilinear(sampled, std::get<Hold::Tustin>(hold));
    }
    if (std::holds_alternative<Hold::Matched>(hold)) {
        if (!isSinglePath(sampled)) {
            return severalPaths();
        }
        const auto factors = toZeroPoleGain(sampled);
        const auto matched = factors ? matchedContinuous(*factors) : factors;
        return matched ? Result<StateSpace>(toStateSpace(*matched)) : noContinuousImage();
    }
    return inverseHold(sampled, hold);
}

Result<TransferFunction> toContinuous(const TransferFunction& sampled, const HoldMethod& hold) {
    if (sampled.timeBase().isContinuous()) {
        return failure(ErrorCode::InvalidInput, "the system is already continuous");
    }
    const auto system = toContinuous(prescaled(toStateSpace(sampled)), hold);
    if (!system) {
        return failure(system.error());
    }
    return toTransferFunction(*system);
}

} // namespace halbench::control
