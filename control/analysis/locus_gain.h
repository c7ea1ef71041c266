#pragma once

#include "control/analysis/root_locus.h"

#include <complex>
#include <cstddef>
#include <optional>
#include <vector>

namespace halbench::control {

/// The branch on which the closed loop has a pole near `pole` at this gain; of a pair the one that is nearer.
/// Nothing for a locus without branches.
std::optional<std::size_t> branchAt(const RootLocus& locus, double gain, std::complex<double> pole);

/// The gain at which a branch comes nearest to a place, between its points along straight lines. The branch
/// and the place are taken to the upper half of the plane: a pair moves together. O(points).
double gainNearest(const RootLocus& locus, std::size_t branch, std::complex<double> place);

/// The open loop of a locus by its roots, gain prod(x - zeros)/prod(x - poles).
struct LocusLoop {
    std::vector<std::complex<double>> zeros;
    std::vector<std::complex<double>> poles;
    double gain = 1.0;
};
/// The loop with these roots whose closed loop has that pole: 1 + L = 0 there.
LocusLoop loopThrough(std::vector<std::complex<double>> zeros, std::vector<std::complex<double>> poles,
                      std::complex<double> closedLoopPole);

/// The same gain, but of the pole itself: at each gain prod(x - poles) + K gain prod(x - zeros) = 0 is solved
/// by Newton's method from the line between the points, and the gain whose root is nearest is sought between
/// them. Exact to 1e-6 of the gain where the pole moves with it; where it hardly moves (close to a zero) the
/// gain is not determined better than the place is given. O(roots^2), some hundredths of a millisecond.
double solvedGainNearest(const RootLocus& locus, std::size_t branch, std::complex<double> place,
                         const LocusLoop& loop);

} // namespace halbench::control
