#pragma once

#include "control/base/result.h"
#include "control/lti/transfer_function.h"

#include <complex>
#include <vector>

namespace halbench::control {

/// First-harmonic gains of elements without memory of their own speed: what a sine of the given amplitude at
/// the input finds in the fundamental of the output (Gelb, Vander Velde, "Multiple-Input Describing
/// Functions", ch. 2 and appendix B). All amplitudes are positive.

/// Slope 1 within +-limit, limit outside: 1 up to the limit, then
/// N = (2/pi)(asin r + r sqrt(1 - r^2)), r = limit/amplitude.
double saturationGain(double amplitude, double limit);
/// The amplitude at which the saturation has a gain in (0, 1).
double saturationAmplitude(double gain, double limit);

/// +-level with switching points at +-hysteresis: N = 4 level/(pi A) (sqrt(1 - (h/A)^2) - j h/A), A >= h.
std::complex<double> relayGain(double amplitude, double level, double hysteresis = 0.0);

/// Coulomb friction level * sgn(velocity) under position A sin(w t) acts as a viscous friction of
/// 4 level/(pi A w): the friction of a slow or small motion damps without bound. In units of level per speed.
double coulombDamping(double level, double amplitude, double frequency_rad_s);

/// A self-sustained oscillation at the input of the nonlinear element.
struct LimitCycle {
    double amplitude = 0.0;
    double frequency_rad_s = 0.0;
    bool isStable = false; ///< a disturbed amplitude returns; otherwise it is the threshold of another state
};

/// Limit cycles of a linear loop closed over a saturation or a relay, 1 + N(A) L(j w) = 0, in ascending
/// amplitude. Good where L is a low pass: what its third harmonic passes, against the first, is the relative
/// error to expect (|L(3 j w)/L(j w)|/3 for a relay). Stability by Loeb's rule, with the sign taken from the
/// closed loops a little below and above the amplitude. Errors: OutOfRange (limit, level or hysteresis).
Result<std::vector<LimitCycle>> saturationCycles(const TransferFunction& loop, double limit);
Result<std::vector<LimitCycle>> relayCycles(const TransferFunction& loop, double level,
                                            double hysteresis = 0.0);

} // namespace halbench::control
