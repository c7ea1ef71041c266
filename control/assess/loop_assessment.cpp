#include "control/assess/loop_assessment.h"

#include "control/assess/open_loop_assessment.h"
#include "control/law/board_gains.h"
#include "control/law/filtered_delta.h"
#include "control/lti/riccati.h"
#include "control/lti/state_space.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace halbench::control {

namespace {

/// sqrt(sum h[k]^2) of a stable sampled system: C X C' + D D' with X = A X A' + B B'.
double impulseNorm(const StateSpace& s) {
    const Eigen::MatrixXd X = solveLyapunov(s.A, s.B * s.B.transpose());
    return std::sqrt((s.C * X * s.C.transpose() + s.D * s.D.transpose()).value());
}

/// From the measured angle to the current, C z^-d/(1 + L), as states: one closed polynomial would put all its
/// slow roots into one row, and C X C' then be the small difference of large parts.
Result<StateSpace> noiseToCurrent(const PositionPlant& plant, const PidGains& gains,
                                  const LoopTiming& timing) {
    const auto controller = sampledController(gains, timing.period_s);
    if (!controller) {
        return failure(controller.error());
    }
    const auto delayed = series(*controller, TransferFunction::delay(timing.delay_samples, timing.period_s));
    if (!delayed) {
        return failure(delayed.error());
    }
    return feedback(toStateSpace(*delayed), toStateSpace(sampledPlant(plant, timing.period_s)));
}

} // namespace

LoopAssessment assessOpenLoop(const DeltaSystem& openLoop, double poleRadius, double poleRadiusOneSampleLater,
                              LoopStep step, double currentLimit_A) {
    LoopAssessment assessment;
    assessment.poleRadius = poleRadius;
    assessment.isStable = assessment.poleRadius < 1.0;
    assessment.margins = smallestMargins(openLoop);
    assessment.peaks = sensitivityPeaks(openLoop);
    for (const double current_A : step.current_A) {
        assessment.peakCurrent_A = std::max(assessment.peakCurrent_A, std::abs(current_A));
    }
    assessment.step = std::move(step);
    assessment.largestStep_rad = currentLimit_A / assessment.peakCurrent_A;
    assessment.poleRadiusOneSampleLater = poleRadiusOneSampleLater;
    return assessment;
}

Result<LoopAssessment> assessDesign(const PositionPlant& plant, const PidGains& gains,
                                    const LoopTiming& timing, double currentLimit_A, double duration_s) {
    if (!(std::isfinite(currentLimit_A) && currentLimit_A > 0.0)) {
        return failure(ErrorCode::OutOfRange, "the current limit must be positive");
    }
    const auto loop = sampledOpenLoop(plant, gains, timing);
    const auto later = sampledOpenLoop(plant, gains, {timing.period_s, timing.delay_samples + 1});
    const auto noise = noiseToCurrent(plant, gains, timing);
    if (!loop || !later || !noise) {
        return failure(!loop ? loop.error() : !later ? later.error() : noise.error());
    }
    FilteredLaw law;
    law.gains = *boardGains(gains);
    const auto factors = deltaOpenLoop(plant, law, timing);
    if (!factors) {
        return failure(factors.error());
    }
    auto step = linearStep(plant, gains, timing, 1.0, duration_s);
    if (!step) {
        return failure(step.error());
    }
    const PidGains& board = law.gains;
    LoopAssessment assessment =
        assessOpenLoop(*factors, poleRadius(*loop), poleRadius(*later), *std::move(step), currentLimit_A);
    assessment.noiseGain_A_per_rad =
        assessment.isStable ? impulseNorm(*noise) : std::numeric_limits<double>::infinity();
    assessment.fastGain_A_per_rad = board.proportional + board.derivative / timing.period_s;
    assessment.proportionalLimit_A_per_rad = proportionalLimit_A_per_rad(plant, timing, board.derivative);
    return assessment;
}

} // namespace halbench::control
