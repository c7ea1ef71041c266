#pragma once

#include "control/base/result.h"
#include "control/lti/zero_pole_gain.h"

namespace halbench::control {

/// z = exp(s T) for each pole and zero; zeros at infinity go to z = -1, but for one. The gain is that at s =
/// 0 with the integrations and differentiations taken out on both sides: lim s^k G(s) = lim ((z-1)/T)^k G(z)
/// (Franklin, Powell, Workman, section 6.2). The period must be positive.
Result<ZeroPoleGain> matchedSampled(const ZeroPoleGain& system, double period_s);

/// s = log(z)/T; zeros within 0.01 of z = -1 are those at infinity (several at one place are found no
/// better). Error: Refused (a pole or zero at zero, a pole on the negative real axis).
Result<ZeroPoleGain> matchedContinuous(const ZeroPoleGain& system);

} // namespace halbench::control
