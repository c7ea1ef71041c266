#pragma once

#include "control/lti/dead_time.h"
#include "control/lti/delta_system.h"
#include "control/lti/frequency_response.h"
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
    /// Where coefficients of z have no digits left at low frequency: below this one nothing is known, and
    /// crossings may be missing. Absent when all was looked at.
    std::optional<double> knownFrom_rad_s = {};
};

/// All crossings in ascending frequency. Scans a logarithmic grid refined around the poles and zeros, from
/// far below the slowest to far above the fastest (sampled: to the Nyquist frequency, which counts when the
/// loop is negative there), then narrows each sign change down to the rounding of the frequency. Help:
/// resources/help/tuning.md, "Margins".
std::vector<Crossing> allCrossings(const TransferFunction& openLoop);
std::vector<Crossing> allCrossings(const DeltaSystem& openLoop);
/// With the exact dead time. Of the endless phase crossings of such a loop those where |L| < 0.01 (a gain
/// margin above 100) are left out, and those after 200 turns of the dead time.
std::vector<Crossing> allCrossings(const DeadTimeSystem& openLoop);
/// Of a measured loop: between neighbouring points log |L| and the unwrapped phase run straight over
/// log frequency. Neighbours more than an octave apart, or more than a right angle of phase, are not joined:
/// what happens between them was not measured.
std::vector<Crossing> allCrossings(const FrequencyResponse& openLoop);

StabilityMargins smallestMargins(const TransferFunction& openLoop);
StabilityMargins smallestMargins(const DeltaSystem& openLoop);
StabilityMargins smallestMargins(const DeadTimeSystem& openLoop);
StabilityMargins smallestMargins(const FrequencyResponse& openLoop);

/// Largest magnitudes of S = 1/(1+L) and T = L/(1+L) over frequency. Ms bounds the margins of every loop:
/// gain margin >= Ms/(Ms-1), phase margin >= 2 asin(1/(2 Ms)) (Astrom, Hagglund, "Advanced PID Control",
/// section 4.5). A peak at rest or at infinity is told with the lowest or highest frequency looked at.
struct SensitivityPeaks {
    double Ms_ratio = 0.0;
    double MsFrequency_rad_s = 0.0;
    double Mt_ratio = 0.0;
    double MtFrequency_rad_s = 0.0;
};
SensitivityPeaks sensitivityPeaks(const TransferFunction& openLoop);
SensitivityPeaks sensitivityPeaks(const DeltaSystem& openLoop);
SensitivityPeaks sensitivityPeaks(const DeadTimeSystem& openLoop);

/// The factors of the gain between which the closed loop is stable, the interval that holds 1 or, when the
/// loop is unstable, the one that is nearest to 1 (in the logarithm).
struct StableGains {
    double from_ratio = 0.0;
    double to_ratio = std::numeric_limits<double>::infinity();

    bool holds(double factor) const { return factor > from_ratio && factor < to_ratio; }
};
/// Nothing for a loop that is unstable at every positive gain. The gains at which poles cross the unit circle
/// are those of `crossings`, of the loop itself, and what L is at rest; between them the poles decide.
std::optional<StableGains> stableGains(const DeltaSystem& openLoop, const std::vector<Crossing>& crossings);
/// The margins of a loop with these stable gains. An unstable loop has the factor to its nearest stable gain,
/// infinite without a frequency when there is none, and a delay margin of 0.
StabilityMargins withStableGains(StabilityMargins margins, const std::vector<Crossing>& crossings,
                                 const std::optional<StableGains>& gains);

} // namespace halbench::control
