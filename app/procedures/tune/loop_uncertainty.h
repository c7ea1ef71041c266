#pragma once

#include "app/procedures/tune/analyse.h"
#include "control/robustness/disturbance_envelope.h"
#include "control/robustness/uncertainty_bands.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace halbench::app {

/// The motors that are drawn from what the identification allows; the same as those of the robustness.
struct UncertaintyDraws {
    int count = 1000;
    std::uint64_t seed = 1;
};

/// Errors: Refused (a motor without covariance: nothing is known of it); of plantFromEstimate.
Result<std::vector<control::PositionPlant>> drawnPlants(const MotorEstimate& estimate,
                                                        const UncertaintyDraws& draws);

/// What the uncertainty of the identified motor makes of the curves: nine tenths of the drawn motors lie
/// between, point by point.
struct LoopUncertainty {
    control::LoopBands loop;
    std::optional<control::StepBand> step;      ///< linear, of 1 rad; nothing for an unstable loop
    std::optional<control::StepBand> largeStep; ///< with friction and current limit; takes longer
};

/// How far and how finely the bands of a motion are computed, and how many points are kept of them.
struct BandExtent {
    double duration_s = 0.0;
    int pointsPerSample = 1;
    std::size_t mostPoints = std::numeric_limits<std::size_t>::max();
};
/// The bands of control/design of whichever law it is. Errors: of theirs.
Result<control::LoopBands> loopBandsOf(const std::vector<control::PositionPlant>& plants, const LoopLaw& law,
                                       const control::LoopTiming& timing,
                                       const std::vector<double>& frequency_rad_s);
Result<control::StepBand> stepBandOf(const std::vector<control::PositionPlant>& plants, const LoopLaw& law,
                                     const control::LoopTiming& timing, double amplitude_rad,
                                     const BandExtent& extent);
Result<control::DisturbanceEnvelope> disturbanceEnvelopeOf(const std::vector<control::PositionPlant>& plants,
                                                           const LoopLaw& law,
                                                           const control::LoopTiming& timing, double load_A,
                                                           const BandExtent& extent);

/// Open loop and linear step of `predicted`, some milliseconds (of a filtered law some tenths of a second);
/// without the large step. Errors: Refused (a
/// motor without covariance: nothing is known of it); of plantFromEstimate and the law.
Result<LoopUncertainty> loopUncertainty(const MotorEstimate& estimate, const LoopLaw& law,
                                        const LoopConditions& conditions, const AnalysisResult& predicted,
                                        const UncertaintyDraws& draws);
/// The same of motors that are drawn already. Errors: of the plants and the law.
Result<LoopUncertainty> loopUncertainty(const std::vector<control::PositionPlant>& plants, const LoopLaw& law,
                                        const LoopConditions& conditions, const AnalysisResult& predicted);

/// How high a step is and how long it is looked at: those of the motor that is judged.
struct StepSpan {
    double amplitude_rad = 0.0;
    double duration_s = 0.0;
};
/// The large step of every motor: 0.1 ms for a second of each. Errors: likewise.
Result<control::StepBand> largeStepBand(const MotorEstimate& estimate, const LoopLaw& law,
                                        const LoopConditions& conditions, const StepSpan& span,
                                        const UncertaintyDraws& draws);

} // namespace halbench::app
