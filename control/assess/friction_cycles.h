#pragma once

#include "control/analysis/describing_function.h"
#include "control/base/result.h"
#include "control/law/position_loop.h"
#include "control/lti/delta_system.h"

#include <vector>

namespace halbench::control {

/// Seconds until the integrator alone breaks the rotor loose that rests with this error:
/// t = (i_s - K_P |e|)/(K_I |e|), i_s the static breakaway current. 0 when K_P does it at once, infinite
/// without integral action or error (help: resources/help/htm-theory.md, 6.7).
double breakLooseTime_s(const PositionPlant& plant, const PidGains& gains, double error_rad,
                        double staticRatio = 1.0);

/// Oscillations of the sampled position loop with Coulomb friction and a current limit, by harmonic balance:
/// the friction becomes the damping 4 i_f k/(pi A w), the limit the gain of a saturation at the current that
/// the controller asks for, and
///     N(A |C|) C(z) z^-delay G(z; a + 4 i_f k/(pi A w)) = -1,  z = exp(j w T).
/// `amplitude` is the angle's in rad (half of peak to peak). The smaller of a pair is unstable: a disturbance
/// beyond it grows into the larger one, below it the rotor comes to rest. The balance sees a sampled relay as
/// a continuous one and the held current for a sine: the true swing lies between 0.5 and 1.5 of the figure,
/// mostly above it by 5 to 25 %, and deep in saturation it is slower as well. Errors: of the inputs;
/// OutOfRange (current limit).
Result<std::vector<LimitCycle>> frictionCycles(const PositionPlant& plant, const PidGains& gains,
                                               const LoopTiming& timing, double currentLimit_A);
/// The same with any controller before the limit, at the sampling of `timing`.
Result<std::vector<LimitCycle>> frictionCycles(const PositionPlant& plant, const DeltaSystem& controller,
                                               const LoopTiming& timing, double currentLimit_A);

} // namespace halbench::control
