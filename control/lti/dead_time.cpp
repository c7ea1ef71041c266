#include "control/lti/dead_time.h"

#include "control/lti/discretize.h"

#include <fmt/format.h>

#include <cmath>

namespace halbench::control {

namespace {

using Complex = std::complex<double>;

/// B of the plant held constant over `time_s`, and exp(A time_s).
struct Held {
    Eigen::MatrixXd transition;
    Eigen::MatrixXd input;
};

Held heldOver(const StateSpace& system, double time_s) {
    if (time_s == 0.0) {
        return {Eigen::MatrixXd::Identity(system.states(), system.states()),
                Eigen::MatrixXd::Zero(system.states(), 1)};
    }
    const StateSpace sampled = *discretize(system, time_s, Hold::Zoh{});
    return {sampled.A, sampled.B};
}

} // namespace

DeadTimeSystem::DeadTimeSystem(TransferFunction rational, double deadTime_s)
    : m_rational(std::move(rational)), m_deadTime_s(deadTime_s) {}

Result<DeadTimeSystem> DeadTimeSystem::make(TransferFunction rational, double deadTime_s) {
    if (rational.timeBase().isSampled()) {
        return failure(ErrorCode::InvalidInput, "the transfer function is already sampled");
    }
    if (!std::isfinite(deadTime_s)) {
        return failure(ErrorCode::NotFinite, "the dead time is not a finite number");
    }
    if (deadTime_s < 0.0) {
        return failure(ErrorCode::OutOfRange, fmt::format("a dead time of {} s is not possible", deadTime_s));
    }
    return DeadTimeSystem(std::move(rational), deadTime_s);
}

std::complex<double> DeadTimeSystem::at(std::complex<double> s) const {
    return m_rational.at(s) * std::exp(-s * m_deadTime_s);
}

std::complex<double> DeadTimeSystem::atFrequency(double frequency_rad_s) const {
    return m_rational.atFrequency(frequency_rad_s) * std::polar(1.0, -frequency_rad_s * m_deadTime_s);
}

Result<DeadTimeSystem> series(const DeadTimeSystem& first, const DeadTimeSystem& second) {
    const auto rational = series(first.rational(), second.rational());
    if (!rational) {
        return failure(rational.error());
    }
    return DeadTimeSystem::make(*rational, first.deadTime_s() + second.deadTime_s());
}

Result<DeadTimeSystem> parallel(const DeadTimeSystem& first, const DeadTimeSystem& second) {
    if (first.deadTime_s() != second.deadTime_s()) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("a system with {} s of dead time cannot be added to one with {} s",
                                   first.deadTime_s(), second.deadTime_s()),
                       "discretize both, or approximate their dead times, first");
    }
    const auto rational = parallel(first.rational(), second.rational());
    if (!rational) {
        return failure(rational.error());
    }
    return DeadTimeSystem::make(*rational, first.deadTime_s());
}

Result<FrequencyResponse> feedbackResponse(const DeadTimeSystem& forward, const DeadTimeSystem& back,
                                           const std::vector<double>& frequency_rad_s) {
    const auto value = [&](double frequency) {
        const Complex open = forward.atFrequency(frequency);
        return open / (1.0 + open * back.atFrequency(frequency));
    };
    return frequencyResponse(value, TimeBase::continuous(), frequency_rad_s);
}

Result<FrequencyResponse> frequencyResponse(const DeadTimeSystem& system,
                                            const std::vector<double>& frequency_rad_s) {
    return frequencyResponse([&](double w) { return system.atFrequency(w); }, TimeBase::continuous(),
                             frequency_rad_s);
}

Result<TransferFunction> withPade(const DeadTimeSystem& system, int order) {
    return system.deadTime_s() == 0.0
               ? system.rational()
               : series(system.rational(), TransferFunction::padeDelay(system.deadTime_s(), order));
}

Result<TransferFunction> discretize(const DeadTimeSystem& system, double period_s) {
    if (const auto base = TimeBase::sampledChecked(period_s); !base) {
        return failure(base.error());
    }
    const StateSpace plant = toStateSpace(system.rational());
    const TimeBase base = TimeBase::sampled(period_s);
    // A dead time of whole samples must not become a fraction of one by rounding.
    const double samples = system.deadTime_s() / period_s;
    const double whole =
        std::abs(samples - std::round(samples)) < 1e-9 ? std::round(samples) : std::floor(samples);
    const double rest_s = std::max(0.0, system.deadTime_s() - whole * period_s);
    const bool isFraction = samples != whole && rest_s > 1e-9 * period_s;
    const Held late = heldOver(plant, isFraction ? period_s - rest_s : period_s);
    const Held early = heldOver(plant, isFraction ? rest_s : 0.0);
    const Eigen::MatrixXd transition = late.transition * early.transition;

    const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(1, 1);
    const auto now =
        toTransferFunction(StateSpace{transition, late.input, plant.C, isFraction ? none : plant.D, base});
    const auto before = toTransferFunction(
        StateSpace{transition, late.transition * early.input, plant.C, isFraction ? plant.D : none, base});
    if (!now || !before) {
        return failure(!now ? now.error() : before.error());
    }
    // (now z + before)/(denominator z^(whole + 1)), or now/(denominator z^whole)
    const Polynomial numerator =
        isFraction ? add(multiply(now->numerator(), {1.0, 0.0}), before->numerator()) : now->numerator();
    Polynomial denominator = now->denominator();
    denominator.resize(denominator.size() + static_cast<std::size_t>(whole) + (isFraction ? 1 : 0), 0.0);
    return TransferFunction::make(numerator, std::move(denominator), base);
}

} // namespace halbench::control
