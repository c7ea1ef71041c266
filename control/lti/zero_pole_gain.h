#pragma once

#include "control/base/result.h"
#include "control/lti/frequency_response.h"
#include "control/lti/state_space.h"
#include "control/lti/transfer_function.h"

#include <complex>
#include <vector>

namespace halbench::control {

/// gain prod(x - zero)/prod(x - pole), x = s or z: keeps every digit of roots decades apart, which the
/// coefficients of a polynomial cannot.
class ZeroPoleGain {
public:
    using Roots = std::vector<std::complex<double>>;

    /// Errors: NotFinite, InvalidInput (complex roots not in conjugate pairs, more zeros than poles).
    static Result<ZeroPoleGain> make(Roots zeros, Roots poles, double gain, TimeBase timeBase);

    const Roots& zeros() const { return m_zeros; }
    const Roots& poles() const { return m_poles; }
    double gain() const { return m_gain; }
    const TimeBase& timeBase() const { return m_timeBase; }

    std::complex<double> at(std::complex<double> point) const;
    std::complex<double> atFrequency(double frequency_rad_s) const;
    /// Infinite for an integrator.
    double dcGain() const;

private:
    ZeroPoleGain(Roots zeros, Roots poles, double gain, TimeBase timeBase);
    Roots m_zeros;
    Roots m_poles;
    double m_gain;
    TimeBase m_timeBase;
};

ZeroPoleGain toZeroPoleGain(const TransferFunction& system);
/// Eigenvalues of A and invariant zeros (`pathZeros`). Error: OutOfRange (input, output).
Result<ZeroPoleGain> toZeroPoleGain(const StateSpace& system, Eigen::Index output = 0,
                                    Eigen::Index input = 0);
Result<TransferFunction> toTransferFunction(const ZeroPoleGain& system);
/// A chain of real sections of first and second order, slowest first, prescaled: rates decades apart stay in
/// sections of their own.
StateSpace toStateSpace(const ZeroPoleGain& system);

/// As of transfer functions; the zeros of a sum and the poles of a feedback come from polynomials.
Result<ZeroPoleGain> series(const ZeroPoleGain& first, const ZeroPoleGain& second);
Result<ZeroPoleGain> parallel(const ZeroPoleGain& first, const ZeroPoleGain& second);
Result<ZeroPoleGain> feedback(const ZeroPoleGain& forward, const ZeroPoleGain& back);

/// Without zeros that lie on poles within `tolerance_ratio` of their size (sampled: of 1).
ZeroPoleGain minimalRealization(const ZeroPoleGain& system, double tolerance_ratio = 1e-8);

/// Errors: OutOfRange for a frequency that is not positive or lies above the Nyquist frequency.
Result<FrequencyResponse> frequencyResponse(const ZeroPoleGain& system,
                                            const std::vector<double>& frequency_rad_s);

} // namespace halbench::control
