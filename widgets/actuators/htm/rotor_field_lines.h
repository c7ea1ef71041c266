#pragma once

#include "models/fields/coil.h"
#include "models/fields/halbach_ring.h"

#include <Eigen/Core>
#include <vector>

namespace halbench::widgets {

/// The cross-section of the Halbach-cylinder motor, rotor frame: field along +x inside.
/// Source: resources/help/htm-theory.md sections 2 and 4.
struct RotorGeometry {
    models::HalbachRing ring;
    models::RadialCoil coil; ///< four of them, 90 degrees apart
    double sensorRadius_m = 14.5e-3;
    double housingRadius_m = 41.0e-3;

    /// The circles that just hold all bars, however they are turned.
    double outerRadius_m() const;
    double boreRadius_m() const;
};

using FieldLine = std::vector<Eigen::Vector2d>; ///< metres; in the direction of the field

/// Lines of the ideal two-dimensional cylinder, equal flux between neighbours. They are level lines of the
/// vector potential: A = B0 y in the bore, A = B_r r sin(theta) ln(R_o/r) in the magnets; nothing outside.
/// Source: resources/help/htm-theory.md section 4.1.
std::vector<FieldLine> idealFieldLines(const RotorGeometry& geometry, int lines);

/// Lines through the separate bars, infinitely long along z; the ring has equal bars, an even number of them.
/// Some 30 ms for 20 lines: compute them once, turn the picture. `lines` is even here and below.
std::vector<FieldLine> segmentedFieldLines(const RotorGeometry& geometry, int lines);

/// Straight lines in the bore: all that a field of one direction, as two sensors see it, can tell.
std::vector<FieldLine> uniformFieldLines(const RotorGeometry& geometry, int lines);

} // namespace halbench::widgets
