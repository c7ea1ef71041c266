#pragma once

#include "control/base/result.h"
#include "control/lti/delta_system.h"
#include "control/lti/transfer_function.h"

#include <complex>
#include <optional>
#include <vector>

namespace halbench::control {

/// Where the closed-loop poles, D(x) + K N(x) = 0, go while the gain K of an open loop rises from 0.
struct RootLocus {
    std::vector<double> gain; ///< ascending from 0, so dense that no branch can be mistaken for another
    /// branch[b][i]: one pole at gain[i]; each begins at an open-loop pole and keeps its identity. Where
    /// branches meet they leave in conjugate directions; which of the two leaves where is a convention.
    std::vector<std::vector<std::complex<double>>> branch;

    struct Breakaway {
        std::complex<double> point;
        double gain = 0.0;
    };
    std::vector<Breakaway> breakaways; ///< double poles at a positive gain, ascending

    struct AxisCrossing {
        double gain = 0.0;
        double frequency_rad_s = 0.0;
    };
    std::vector<AxisCrossing> axisCrossings; ///< of the imaginary axis or the unit circle, ascending in gain

    /// The branches without a zero to end at leave along rays from the centroid.
    double asymptoteCentroid = 0.0;
    std::vector<double> asymptoteAngles_rad;
};

/// Follows the branches up to `mostGain`; without it until those that end at zeros have arrived within 1 %
/// and the others have left the region of the open-loop poles and zeros five times behind. The gain step
/// shrinks until each pole moves far less than from its neighbours, so that the nearest is the same one; only
/// at a breakaway this cannot be, and there the gain is stepped across. At most some 6000 points. For K < 0
/// negate the loop. Errors: InvalidInput (no poles, or a loop of zero), OutOfRange (gain not positive).
Result<RootLocus> rootLocus(const TransferFunction& openLoop, std::optional<double> mostGain = {});
/// In the z plane, followed in d = z - 1: branches of slow filters, close together at z = 1, stay apart.
Result<RootLocus> rootLocus(const DeltaSystem& openLoop, std::optional<double> mostGain = {});

} // namespace halbench::control
