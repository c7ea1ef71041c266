#include "control/lti/transfer_function.h"

#include "control/base/assert.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace halbench::control {

namespace {

bool isFinite(const Polynomial& polynomial) {
    return std::all_of(polynomial.begin(), polynomial.end(), [](double c) { return std::isfinite(c); });
}

} // namespace

TransferFunction::TransferFunction(Polynomial numerator, Polynomial denominator, TimeBase timeBase)
    : m_numerator(trimmed(std::move(numerator))), m_denominator(trimmed(std::move(denominator))),
      m_timeBase(timeBase) {}

Result<TransferFunction> TransferFunction::make(Polynomial numerator, Polynomial denominator,
                                                TimeBase timeBase) {
    if (!isFinite(numerator) || !isFinite(denominator)) {
        return failure(ErrorCode::NotFinite, "a coefficient of the transfer function is not a finite number");
    }
    TransferFunction system(std::move(numerator), std::move(denominator), timeBase);
    if (system.m_denominator == Polynomial{0.0}) {
        return failure(ErrorCode::InvalidInput, "the denominator of the transfer function is zero");
    }
    if (degree(system.m_numerator) > degree(system.m_denominator)) {
        return failure(ErrorCode::InvalidInput, "the transfer function has more zeros than poles",
                       "add the filter or actuator of the real system");
    }
    return system;
}

TransferFunction TransferFunction::gain(double gain, TimeBase timeBase) {
    HB_ASSERT(std::isfinite(gain));
    return TransferFunction({gain}, {1.0}, timeBase);
}

TransferFunction TransferFunction::delay(int samples, double period_s) {
    HB_ASSERT(samples >= 0);
    Polynomial denominator(static_cast<std::size_t>(samples) + 1, 0.0);
    denominator.front() = 1.0;
    return TransferFunction({1.0}, std::move(denominator), TimeBase::sampled(period_s));
}

TransferFunction TransferFunction::padeDelay(double delay_s, int order) {
    HB_ASSERT(delay_s >= 0.0 && std::isfinite(delay_s) && order >= 1 && order <= 10);
    // c_i = (2n-i)! n! / ((2n)! i! (n-i)!), denominator sum c_i (s delay)^i, numerator with alternating
    // signs.
    Polynomial numerator;
    Polynomial denominator;
    double coefficient = 1.0;
    double power = 1.0;
    for (int i = 0; i <= order; ++i) {
        denominator.insert(denominator.begin(), coefficient * power);
        numerator.insert(numerator.begin(), (i % 2 == 0 ? 1.0 : -1.0) * coefficient * power);
        coefficient *= static_cast<double>(order - i) / static_cast<double>((2 * order - i) * (i + 1));
        power *= delay_s;
    }
    return TransferFunction(std::move(numerator), std::move(denominator), TimeBase::continuous());
}

std::complex<double> TransferFunction::at(std::complex<double> point) const {
    const std::complex<double> numerator = evaluate(m_numerator, point);
    const std::complex<double> denominator = evaluate(m_denominator, point);
    const double square = std::norm(denominator);
    if (!std::isnormal(square)) {
        return numerator / denominator; // at a pole, or beyond the range of a plain quotient
    }
    return {(numerator.real() * denominator.real() + numerator.imag() * denominator.imag()) / square,
            (numerator.imag() * denominator.real() - numerator.real() * denominator.imag()) / square};
}

std::complex<double> TransferFunction::atFrequency(double frequency_rad_s) const {
    if (m_timeBase.isContinuous()) {
        return at({0.0, frequency_rad_s});
    }
    return at(std::polar(1.0, frequency_rad_s * m_timeBase.period_s()));
}

double TransferFunction::dcGain() const {
    const double point = m_timeBase.isContinuous() ? 0.0 : 1.0;
    const double numerator = evaluate(m_numerator, point).real();
    const double denominator = evaluate(m_denominator, point).real();
    return denominator == 0.0 ? std::numeric_limits<double>::infinity() : numerator / denominator;
}

Result<TransferFunction> series(const TransferFunction& first, const TransferFunction& second) {
    const auto base = commonTimeBase(first.timeBase(), second.timeBase());
    if (!base) {
        return failure(base.error());
    }
    return TransferFunction::make(multiply(first.numerator(), second.numerator()),
                                  multiply(first.denominator(), second.denominator()), *base);
}

Result<TransferFunction> parallel(const TransferFunction& first, const TransferFunction& second) {
    const auto base = commonTimeBase(first.timeBase(), second.timeBase());
    if (!base) {
        return failure(base.error());
    }
    return TransferFunction::make(add(multiply(first.numerator(), second.denominator()),
                                      multiply(second.numerator(), first.denominator())),
                                  multiply(first.denominator(), second.denominator()), *base);
}

Result<TransferFunction> feedback(const TransferFunction& forward, const TransferFunction& back) {
    const auto base = commonTimeBase(forward.timeBase(), back.timeBase());
    if (!base) {
        return failure(base.error());
    }
    const Polynomial open = multiply(forward.denominator(), back.denominator());
    const Polynomial closed = add(open, multiply(forward.numerator(), back.numerator()));
    if (degree(closed) < degree(open)) {
        return failure(ErrorCode::InvalidInput, "the feedback closes an algebraic loop with 1 + L = 0",
                       "an algebraic loop: one of the two systems needs a delay");
    }
    return TransferFunction::make(multiply(forward.numerator(), back.denominator()), closed, *base);
}

std::vector<std::complex<double>> poles(const TransferFunction& system) {
    return roots(system.denominator());
}

std::vector<std::complex<double>> zeros(const TransferFunction& system) {
    return roots(system.numerator());
}

bool isStable(const TransferFunction& system) {
    const auto all = poles(system);
    const bool isSampled = system.timeBase().isSampled();
    return std::all_of(all.begin(), all.end(), [isSampled](const std::complex<double>& pole) {
        return isSampled ? std::abs(pole) < 1.0 : pole.real() < 0.0;
    });
}

std::vector<Damping> damping(const TransferFunction& system) {
    return damping(poles(system), system.timeBase());
}

std::vector<Damping> damping(const std::vector<std::complex<double>>& poles, const TimeBase& timeBase) {
    std::vector<Damping> result;
    for (const std::complex<double>& pole : poles) {
        std::complex<double> s = pole;
        if (timeBase.isSampled()) {
            if (pole == 0.0) {
                continue; // a pure delay has no image in the s plane
            }
            s = std::log(pole) / timeBase.period_s();
        }
        const double frequency = std::abs(s);
        result.push_back({pole, frequency, frequency > 0.0 ? -s.real() / frequency : 1.0});
    }
    return result;
}

} // namespace halbench::control
