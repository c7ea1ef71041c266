#include "app/procedures/apply/live_step_judge.h"

#include "app/procedures/tune/large_step.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::app {
namespace {

using control::PositionLaw;

Result<void> admit(const TuneResult& judged, const StepNumber& step) {
    constexpr double MostUnstable_ratio = 0.01;
    constexpr double LeastPhase_deg = 1.0;
    constexpr double LeastGain_ratio = 1.1;
    const control::Robustness& robust = judged.robust;
    // A loop that integrates more than its motor damps has a limit below its gain too, maybe the nearer one.
    const double gain = std::max(robust.gainMarginEitherWay_ratio_p5.value_or(0.0), 0.0);
    const double phase_deg = robust.phaseMargin_deg_p5.value_or(0.0);
    const bool isRobust = robust.unstable_fraction < MostUnstable_ratio && phase_deg >= LeastPhase_deg &&
                          gain >= LeastGain_ratio;
    if (judged.predicted.isStable && isRobust) {
        return {};
    }
    return failure(ErrorCode::Refused,
                   fmt::format("step {} of {} is not safe: unstable for {:.1f} % of the motors within the "
                               "uncertainty, margins {:.3g} deg and {:.3g}",
                               step.number, step.count,
                               judged.predicted.isStable ? 100.0 * robust.unstable_fraction : 100.0,
                               phase_deg, gain),
                   "nothing was written; use gains with larger margins, or identify more precisely");
}

std::vector<control::ReferencePoint> stepReference(const LiveApplyConfig& config) {
    return {1, control::ReferencePoint{config.amplitude_rad, 0.0, 0.0}};
}

Result<MotionEnvelope> bandOf(const PositionLaw& law, const std::vector<RunMotor>& motors,
                              const LiveApplyConfig& config) {
    const auto board = simulatedLaw(law, config.conditions);
    if (!board) {
        return failure(board.error());
    }
    const auto reference = stepReference(config);
    const auto rows = static_cast<std::size_t>(std::lround(1e3 * config.duration_s)) + 1;
    return expectedMotion(motors, *board, reference, rows);
}

} // namespace

Result<std::vector<RunMotor>> liveMotors(const LiveApplyConfig& config) {
    return bandMotors(config.motor, config.draws);
}

Result<LiveStep> judgeLiveStep(const PositionLaw& law, const std::vector<RunMotor>& motors,
                               const LiveApplyConfig& config, const StepNumber& step) {
    TuneConfig tuning;
    tuning.method = "edited";
    tuning.conditions = config.conditions;
    tuning.draws = config.draws.count;
    tuning.seed = config.draws.seed;
    const auto judged = judgeLaw(config.motor, law, tuning);
    if (!judged) {
        return failure(judged.error());
    }
    if (const auto admitted = admit(*judged, step); !admitted) {
        return failure(admitted.error());
    }
    auto band = bandOf(law, motors, config);
    if (!band) {
        return failure(band.error());
    }
    return LiveStep{law, judged->robust, *std::move(band)};
}

} // namespace halbench::app
