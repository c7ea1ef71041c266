#pragma once

#include "control/base/result.h"
#include "control/lti/time_base.h"
#include "control/lti/zero_pole_gain.h"

#include <complex>
#include <vector>

namespace halbench::control {

/// A sampled system by its roots in d = z - 1: gain prod(d - zero)/prod(d - pole). Integrators and slow
/// filters lie together at z = 1, where coefficients of z lose their digits and roots of z some of them; in d
/// all digits are kept (Middleton, Goodwin, "Digital Control and Estimation", chapter 3).
class DeltaSystem {
public:
    using Roots = std::vector<std::complex<double>>;

    /// Complex roots come in conjugate pairs. Errors: NotFinite, InvalidInput (more zeros than poles).
    static Result<DeltaSystem> make(Roots zeros, Roots poles, double gain, const TimeBase& timeBase);
    /// A factor numerator/denominator in powers of d, each of at most second order. Errors: as above, and
    /// InvalidInput for a denominator of zero.
    static Result<DeltaSystem> factor(const Polynomial& numerator, const Polynomial& denominator,
                                      const TimeBase& timeBase);

    const Roots& zeros() const { return m_zeros; }
    const Roots& poles() const { return m_poles; }
    double gain() const { return m_gain; }
    const TimeBase& timeBase() const { return m_timeBase; }

    /// Value at a point of the d plane.
    std::complex<double> at(std::complex<double> d) const;
    std::complex<double> atFrequency(double frequency_rad_s) const;
    /// The same values, four frequencies at once.
    std::vector<std::complex<double>> atFrequencies(const std::vector<double>& frequency_rad_s) const;
    /// Infinite for an integrator.
    double dcGain() const;

private:
    DeltaSystem(Roots zeros, Roots poles, double gain, const TimeBase& timeBase);
    Roots m_zeros;
    Roots m_poles;
    double m_gain;
    TimeBase m_timeBase;
};

/// Error: InvalidInput for mixed time bases.
Result<DeltaSystem> series(const DeltaSystem& first, const DeltaSystem& second);
/// A sampled system given by its roots in z.
Result<DeltaSystem> toDeltaSystem(const ZeroPoleGain& system);

/// In the z plane.
std::vector<std::complex<double>> poles(const DeltaSystem& system);
std::vector<std::complex<double>> zeros(const DeltaSystem& system);

/// Poles in d of the loop closed with this factor, prod(d - poles) + factor gain prod(d - zeros) = 0, by the
/// simultaneous iteration of Aberth (1973) on the products themselves, from any start of as many points. Each
/// is found to some roundings of its own size, of m that lie together to the m-th root of it.
DeltaSystem::Roots closedLoopRoots(const DeltaSystem& openLoop, double factor, DeltaSystem::Roots start);
/// The same from the open loop's poles.
DeltaSystem::Roots closedLoopRoots(const DeltaSystem& openLoop, double factor);
/// Whether all of them lie inside the unit circle, |1 + d| < 1.
bool isStableClosed(const DeltaSystem& openLoop, double factor);

/// exp(s T) - 1 without cancellation, and its inverse, ln(1 + d)/T.
std::complex<double> deltaOf(std::complex<double> s_rad_s, double period_s);
std::complex<double> rateOf(std::complex<double> d, double period_s);

} // namespace halbench::control
