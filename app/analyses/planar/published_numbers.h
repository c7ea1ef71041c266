#pragma once

#include "models/planar/planar_geometry.h"

#include <string_view>
#include <vector>

namespace halbench::app {

/// One number that follows from the models, and what the publication prints for it.
struct PublishedNumber {
    std::string_view name; ///< with its unit
    double value = 0.0;
    std::string_view printed = {}; ///< empty: it prints none
};

/// The numbers of resources/help/planar-theory.md sections 4, 5 and 10, recomputed: force constants and their
/// harmonics, what the printed subscripts would give, base points, phases and torque signs, peak field,
/// divergence with the printed sign, set force, bearing deflection and tilts, power, speeds at the end of the
/// ramps, inertias, share of the eddy currents' field.
std::vector<PublishedNumber> publishedNumbers(const models::PlanarGeometry& geometry);

} // namespace halbench::app
