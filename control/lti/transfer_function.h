#pragma once

#include "control/base/result.h"
#include "control/lti/polynomial.h"
#include "control/lti/time_base.h"

#include <complex>
#include <vector>

namespace halbench::control {

/// A rational single-input single-output system: numerator(x)/denominator(x), x = s or z.
/// Proper by construction (degree of the numerator <= degree of the denominator).
class TransferFunction {
public:
    /// Errors: NotFinite, InvalidInput (zero denominator, improper).
    static Result<TransferFunction> make(Polynomial numerator, Polynomial denominator, TimeBase timeBase);
    static TransferFunction gain(double gain, TimeBase timeBase);
    /// z^-samples on a sampled base.
    static TransferFunction delay(int samples, double period_s);
    /// exp(-s delay_s) as a Pade approximation of the given order (1 ... 10); all-pass, exact at s = 0.
    static TransferFunction padeDelay(double delay_s, int order);

    const Polynomial& numerator() const { return m_numerator; }
    const Polynomial& denominator() const { return m_denominator; }
    const TimeBase& timeBase() const { return m_timeBase; }
    int order() const { return degree(m_denominator); }

    /// Value at a point of the s or z plane.
    std::complex<double> at(std::complex<double> point) const;
    /// Frequency response: the value at s = j omega, or at z = exp(j omega T).
    std::complex<double> atFrequency(double frequency_rad_s) const;
    /// Gain for constant input: value at s = 0 or z = 1; infinite for an integrator.
    double dcGain() const;

private:
    TransferFunction(Polynomial numerator, Polynomial denominator, TimeBase timeBase);
    Polynomial m_numerator;
    Polynomial m_denominator;
    TimeBase m_timeBase;
};

/// first * second, first + second, forward / (1 + forward * back). Error: InvalidInput for mixed time bases;
/// feedback also for an algebraic loop with 1 + L = 0.
Result<TransferFunction> series(const TransferFunction& first, const TransferFunction& second);
Result<TransferFunction> parallel(const TransferFunction& first, const TransferFunction& second);
Result<TransferFunction> feedback(const TransferFunction& forward, const TransferFunction& back);

std::vector<std::complex<double>> poles(const TransferFunction& system);
std::vector<std::complex<double>> zeros(const TransferFunction& system);

/// All poles strictly inside: real part < 0, or modulus < 1.
bool isStable(const TransferFunction& system);

/// Natural frequency and damping ratio of one pole; for a sampled system of its image s = ln(z)/T.
struct Damping {
    std::complex<double> pole;
    double naturalFrequency_rad_s = 0.0;
    double damping_ratio = 0.0;
};
std::vector<Damping> damping(const TransferFunction& system);
std::vector<Damping> damping(const std::vector<std::complex<double>>& poles, const TimeBase& timeBase);

} // namespace halbench::control
