#include "models/planar/planar_linear.h"

#include "control/base/units.h"

#include <cmath>

namespace halbench::models {

std::array<PlanarAxisPlant, 3> linearize(const PlanarParameters& parameters) {
    const PlanarAxisPlant along{parameters.damping_Ns_per_m / parameters.mass_kg, 1.0 / parameters.mass_kg,
                                0.0};
    return {along,
            along,
            {parameters.damping_Nms_per_rad / parameters.inertia_kg_m2, 1.0 / parameters.inertia_kg_m2, 0.0}};
}

double axisGain_per_effort(const PlanarAxisPlant& plant, double frequency_Hz, double period_s) {
    const double omega = 2.0 * Pi * frequency_Hz;
    const double x = Pi * frequency_Hz * period_s;
    const double hold = x > 0.0 ? std::sin(x) / x : 1.0;
    return std::fabs(hold) * plant.accelerationGain / (omega * std::hypot(omega, plant.dampingRate_1_s));
}

} // namespace halbench::models
