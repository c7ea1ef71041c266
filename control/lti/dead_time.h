#pragma once

#include "control/base/result.h"
#include "control/lti/frequency_response.h"
#include "control/lti/state_space.h"
#include "control/lti/transfer_function.h"

#include <complex>
#include <vector>

namespace halbench::control {

/// A continuous system behind a dead time: G(s) exp(-s deadTime_s). Exact in the frequency domain; exact on
/// samples behind a zero-order hold (`discretize`); rational only approximately (`withPade`).
class DeadTimeSystem {
public:
    /// Errors: InvalidInput (sampled: use TransferFunction::delay), NotFinite, OutOfRange (negative).
    static Result<DeadTimeSystem> make(TransferFunction rational, double deadTime_s);

    const TransferFunction& rational() const { return m_rational; }
    double deadTime_s() const { return m_deadTime_s; }
    std::complex<double> at(std::complex<double> s) const;
    std::complex<double> atFrequency(double frequency_rad_s) const;

private:
    DeadTimeSystem(TransferFunction rational, double deadTime_s);
    TransferFunction m_rational;
    double m_deadTime_s;
};

/// G1 G2 with the sum of the dead times. Errors: none beyond those of the rational parts.
Result<DeadTimeSystem> series(const DeadTimeSystem& first, const DeadTimeSystem& second);
/// G1 + G2. Error: InvalidInput when the dead times differ (no rational system behind one dead time does it).
Result<DeadTimeSystem> parallel(const DeadTimeSystem& first, const DeadTimeSystem& second);
/// forward / (1 + forward back), exact at each frequency; a closed loop around a dead time is no
/// DeadTimeSystem. Errors: OutOfRange (a frequency that is not positive).
Result<FrequencyResponse> feedbackResponse(const DeadTimeSystem& forward, const DeadTimeSystem& back,
                                           const std::vector<double>& frequency_rad_s);

Result<FrequencyResponse> frequencyResponse(const DeadTimeSystem& system,
                                            const std::vector<double>& frequency_rad_s);

/// The dead time as Pade approximation of order 1 ... 10: phase right to 1 % up to about w = order/deadTime.
Result<TransferFunction> withPade(const DeadTimeSystem& system, int order);

/// Exact sampled equivalent behind a zero-order hold for any dead time, with deadTime = l T + tau, 0 <= tau <
/// T:
///   x[k+1] = exp(A T) x[k] + Gamma(T - tau) u[k-l] + exp(A (T - tau)) Gamma(tau) u[k-l-1]
/// (Astrom, Wittenmark, "Computer-Controlled Systems", section 3.2). Errors: OutOfRange, NotFinite (period).
Result<TransferFunction> discretize(const DeadTimeSystem& system, double period_s);

} // namespace halbench::control
