#pragma once

#include "control/analysis/margins.h"
#include "control/base/result.h"
#include "control/law/position_loop.h"

namespace halbench::control {

/// What a design is worth on the sampled loop it will run in: every design method returns it, whatever it
/// promised on paper.
struct LoopAssessment {
    bool isStable = false;
    double poleRadius = 0.0;
    StabilityMargins margins;
    SensitivityPeaks peaks;
    LoopStep step;                ///< of 1 rad, linear: no friction, no current limit
    double peakCurrent_A = 0.0;   ///< largest current of that step
    double largestStep_rad = 0.0; ///< the step that reaches the current limit, while the loop is linear
    /// Standard deviation of the current per standard deviation of independent errors of each measured angle:
    /// the H2 norm of C/(1 + L).
    double noiseGain_A_per_rad = 0.0;
    /// Gain towards fast errors of the angle, K_P + K_D/T: must stay below B_0/|error of k_s| where the
    /// coils' field reaches the sensors (help: resources/help/htm-theory.md, 8.4).
    double fastGain_A_per_rad = 0.0;
    double proportionalLimit_A_per_rad = 0.0; ///< of K_P with this K_D, sampling and delay
    double poleRadiusOneSampleLater = 0.0; ///< with one more sample of delay: above 1 is sensitive to delay
};

/// Errors: of the inputs; OutOfRange (current limit, duration); Refused when the loop is so unstable that its
/// step grows beyond all numbers. An unstable loop is proved all the same, with a noise gain of infinity.
Result<LoopAssessment> assessDesign(const PositionPlant& plant, const PidGains& gains,
                                    const LoopTiming& timing, double currentLimit_A, double duration_s = 2.0);

} // namespace halbench::control
