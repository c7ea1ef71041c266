#pragma once

#include "control/design/design_methods.h"
#include "control/law/filtered_law.h"

#include <string_view>
#include <vector>

namespace halbench::control {

/// Designs for an axis that moves freely, q'' + a q' = k u with little damping: a PID with the set-point
/// weight b on the proportional term, c = 0 and a derivative filter (resources/help/tuning.md, "Loops of
/// several axes"). The continuous loop without its delays has the poles -p, and -w twice or, with a damping
/// ratio zeta, the pair of natural frequency w:
///     k K_P = w^2 + 2 zeta w p,   k K_I = p w^2,   k K_D = 2 zeta w + p - a.
/// A free mass integrates twice, so with b = 1 the error after a step integrates to zero and overshoot is
/// certain; b = 0.745 has none. The derivative filter decays as exp(-t/2 T_s).
/// Source: resources/help/planar-theory.md section 9, of which p = 2.2/s is kept up to a thirteenth of w.

/// recommended, pole-placement, bandwidth, phase-margin, lqr, lead.
const std::vector<DesignMethod>& axisDesignMethods();

/// The frequency w that the delays allow at ease: 0.105 over the sum of computing delay, half a period of
/// hold and derivative filter (30 rad/s at 1 ms and one sample of delay, 63 degrees of phase margin).
double usualAxisFrequency_rad_s(const LoopTiming& timing);

/// The law of these poles. Errors: OutOfRange (an axis that damps more than the poles ask for).
Result<FilteredLaw> axisLaw(const PositionPlant& plant, const LoopTiming& timing, double frequency_rad_s,
                            double zeta_ratio = 1.0);

/// `usual_rad_s`: w of method recommended where the timing allows it (45 degrees of phase margin), else it is
/// lowered; 0: usualAxisFrequency_rad_s. Errors: UnknownName (method), Usage (a target that is missing or not
/// read), NotFinite, OutOfRange (a target that is out of reach; the hint says what is not).
Result<FilteredLaw> designAxisLaw(std::string_view method, const PositionPlant& plant,
                                  const LoopTiming& timing, const DesignTargets& targets,
                                  double usual_rad_s = 0.0);

} // namespace halbench::control
