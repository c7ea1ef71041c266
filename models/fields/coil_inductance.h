#pragma once

#include "models/fields/coil.h"

namespace halbench::models {

/// Inductance of a coil alone, H: the sum of Neumann's integral over all pairs of its filaments,
///   M(l1, l2, d) = mu0/(4 pi) 2 [F((l1 + l2)/2) - F((l1 - l2)/2)],  F(z) = z asinh(z/d) - sqrt(z^2 + d^2)
/// for parallel sides with a common middle; a filament meets itself at the geometric mean distance of its
/// share of the winding, 0.2235 (width + height) (Grover, Inductance Calculations, ch. 3). The end turns run
/// as far outside the active length as the winding is wide. Eight sections are within 0.5 % of the limit.
double coilInductance_H(const RadialCoil& coil, int sections = 8);

/// Mutual inductance of a coil and the one opposite, both with their axes along the same direction: what two
/// coils of a phase in series add twice.
double oppositeCoilInductance_H(const RadialCoil& coil, int sections = 8);

} // namespace halbench::models
