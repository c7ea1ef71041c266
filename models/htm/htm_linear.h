#pragma once

#include "models/htm/htm_rotor.h"

namespace halbench::models {

/// The motor without Coulomb friction, current to angle: G(s) = phi/(J s^2 + c s) = k/(s (s + a)).
/// Source: resources/help/htm-theory.md sections 2 and 3.7.
struct HtmLinearPlant {
    double rate_per_s = 0.0;            ///< a = c/J
    double gain_rad_per_s2_per_A = 0.0; ///< k = phi/J
    double friction_rad_per_s2 = 0.0;   ///< f = K_f/J: what Coulomb friction takes off any acceleration
};

HtmLinearPlant linearize(const RotorConfig& rotor, double torqueConstant_Nm_per_A);

/// Current held for T_s: G(z) = (b1 z + b2)/((z - 1)(z - E)), E = e^(-a T_s),
///   b1 = (k/a^2)(a T_s - 1 + E),  b2 = (k/a^2)(1 - E - a T_s E);  the limits hold for a = 0.
struct HtmSampledPlant {
    double b1_rad_per_A = 0.0;
    double b2_rad_per_A = 0.0;
    double decay_ratio = 0.0; ///< E
};

HtmSampledPlant samplePlant(const HtmLinearPlant& plant, double period_s);

} // namespace halbench::models
