#include "models/planar/planar_geometry.h"

#include <cmath>

namespace halbench::models {

std::array<PlanarCoil, CoilCount> PlanarGeometry::coils() const {
    const double x_m = 0.75 * matrix.pitch_m;
    const double upper_m = arm56_m - matrix.pitch_m;
    // The second of a pair stands 3L/4 further: 270 degrees of phase.
    const double lower_m = upper_m - 0.75 * matrix.pitch_m;
    const double left_m = -x_m + winding.width_m;
    return {{{{-x_m, upper_m}, false, 1.0},
             {{-x_m, lower_m}, false, 1.0},
             {{x_m, lower_m}, false, 1.0},
             {{x_m, upper_m}, false, 1.0},
             {{left_m + 1.25 * matrix.pitch_m, arm56_m}, true, -1.0},
             {{left_m, arm56_m}, true, -1.0}}};
}

double coilHeightIntegral_Tm(const PlanarGeometry& geometry, int order) {
    const double g = order * waveNumber_per_m(geometry.matrix);
    return harmonicAmplitude_T(geometry.matrix, order, geometry.gap_m) *
           -std::expm1(-g * geometry.winding.height_m) / g;
}

} // namespace halbench::models
