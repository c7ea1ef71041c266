#pragma once

#include "control/lti/transfer_function.h"

#include <limits>
#include <optional>
#include <vector>

namespace halbench::control {

/// One crossing of an open loop: of the unit circle (gain) or of the negative real axis (phase).
struct Crossing {
    enum class Kind { Gain, Phase };
    Kind kind = Kind::Gain;
    double frequency_rad_s = 0.0;
    double phaseMargin_deg = 0.0;  ///< gain crossing: 180 deg + phase, in (-180, 180]
    double delayMargin_s = 0.0;    ///< gain crossing: dead time that brings it onto -1
    double gainMargin_ratio = 1.0; ///< phase crossing: factor that brings it onto -1
};

/// The smallest margins of a loop under negative unit feedback. A margin without a crossing is infinite and
/// its frequency absent. They say how far the loop is from the limit of stability, on whichever side it is:
/// ask `isStable` of the closed loop beside them.
struct StabilityMargins {
    /// Crossing factor nearest to 1 (in the logarithm); below 1 when the gain may only fall.
    double gainMargin_ratio = std::numeric_limits<double>::infinity();
    double phaseMargin_deg = std::numeric_limits<double>::infinity(); ///< nearest to zero
    std::optional<double> gainCrossover_rad_s;                        ///< where `phaseMargin_deg` was found
    std::optional<double> phaseCrossover_rad_s;                       ///< where `gainMargin_ratio` was found
    double delayMargin_s = std::numeric_limits<double>::infinity();   ///< smallest
    double modulusMargin = 0.0; ///< min |1 + L|, the inverse of the peak of the sensitivity
};

/// All crossings in ascending frequency. Scans a logarithmic grid refined around the poles and zeros, from
/// far below the slowest to far above the fastest (sampled: to the Nyquist frequency, which counts when the
/// loop is negative there), then narrows each sign change down to the rounding of the frequency. Help:
/// resources/help/tuning.md, "Margins".
std::vector<Crossing> allCrossings(const TransferFunction& openLoop);

StabilityMargins smallestMargins(const TransferFunction& openLoop);

} // namespace halbench::control
