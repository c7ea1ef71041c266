#include "models/htm/htm_linear.h"

#include <cmath>

namespace halbench::models {

HtmLinearPlant linearize(const RotorConfig& rotor, double torqueConstant_Nm_per_A) {
    return {rotor.viscousDamping_Nm_s / rotor.inertia_kg_m2, torqueConstant_Nm_per_A / rotor.inertia_kg_m2,
            rotor.coulombFriction_Nm / rotor.inertia_kg_m2};
}

HtmSampledPlant samplePlant(const HtmLinearPlant& plant, double period_s) {
    const double x = plant.rate_per_s * period_s;
    const double decay = std::exp(-x);
    const double scale = plant.gain_rad_per_s2_per_A * period_s * period_s;
    if (x < 1e-4) {
        // The differences below cancel; two terms of the series leave less than 1e-9 of the value.
        return {scale * (0.5 - x / 6.0 + x * x / 24.0), scale * (0.5 - x / 3.0 + x * x / 8.0), decay};
    }
    return {scale * (x + std::expm1(-x)) / (x * x), scale * (-std::expm1(-x) - x * decay) / (x * x), decay};
}

} // namespace halbench::models
