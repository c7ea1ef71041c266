#pragma once

#include "models/planar/planar_parameters.h"

#include <array>

namespace halbench::models {

/// One axis without its neighbours: q'' + a q' = k (u - u_f sgn q'), u: force or torque about the real centre
/// of mass, SI of the axis.
struct PlanarAxisPlant {
    double dampingRate_1_s = 0.0;  ///< a = c/m or c_phi/Iz
    double accelerationGain = 0.0; ///< k = 1/m in 1/kg, 1/Iz in 1/(kg m^2)
    double breakawayEffort = 0.0;  ///< u_f: zero on air bearings
};

/// x, y and angle. The cable is left out: at 2 N/m it turns 0.28 Hz of free motion into a swing, far below
/// any crossover. Source: resources/help/planar-theory.md section 8.
std::array<PlanarAxisPlant, 3> linearize(const PlanarParameters& parameters);

/// |q/u| at one frequency with the effort held over each period (zero-order hold of the true output, as
/// measured):
///   |sinc(f T)| |1/((j w)^2 + a j w)| k.
double axisGain_per_effort(const PlanarAxisPlant& plant, double frequency_Hz, double period_s);

} // namespace halbench::models
