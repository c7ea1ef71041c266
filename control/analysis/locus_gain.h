#pragma once

#include "control/analysis/root_locus.h"

#include <complex>
#include <cstddef>
#include <optional>

namespace halbench::control {

/// The branch on which the closed loop has a pole near `pole` at this gain; of a pair the one that is nearer.
/// Nothing for a locus without branches.
std::optional<std::size_t> branchAt(const RootLocus& locus, double gain, std::complex<double> pole);

/// The gain at which a branch comes nearest to a place, between its points along straight lines. The branch
/// and the place are taken to the upper half of the plane: a pair moves together. O(points).
double gainNearest(const RootLocus& locus, std::size_t branch, std::complex<double> place);

} // namespace halbench::control
