#include "app/procedures/analyse.h"

#include "app/procedures/large_step.h"
#include "app/procedures/loop_prediction.h"
#include "control/base/units.h"
#include "control/design/board_gains.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {

namespace {

constexpr double LargeStep_deg = 100.0;

using control::PidGains;

Result<PidGains> checkedGains(const control::PositionLaw& law) {
    auto gains = control::boardGains(law.gains);
    if (!gains) {
        return gains;
    }
    const auto valid = checkPositionGains(*gains);
    return valid ? gains : failure(valid.error());
}

Result<void> stepLoop(AnalysisResult& result, const control::PositionPlant& plant, const PidGains& gains,
                      const control::LoopTiming& timing) {
    auto step = control::linearStep(plant, gains, timing, 1.0, stepDuration_s(result, timing.period_s));
    if (!step) {
        return failure(step.error());
    }
    takeStep(result, *std::move(step));
    return {};
}

void addSaturationNote(AnalysisResult& result, const PidGains& gains, double currentLimit_A) {
    const double largest_deg = radiansToDegrees(currentLimit_A / gains.proportional);
    constexpr double NotableOvershoot_percent = 15.0;
    if (result.isStable && result.largeStep->metrics.overshoot_percent > NotableOvershoot_percent &&
        largest_deg < LargeStep_deg) {
        result.warnings.push_back(
            {"large_steps_overshoot",
             fmt::format("steps above {:.3g} deg reach the current limit of {:.3g} A; with it and with "
                         "friction a step "
                         "of {:.0f} deg overshoots by {:.3g} %",
                         largest_deg, currentLimit_A, LargeStep_deg,
                         result.largeStep->metrics.overshoot_percent),
             "lead large moves along a ramp, or choose a slower loop"});
    }
}

/// Everything that the open loop tells.
Result<AnalysisResult> predictLoop(const control::PositionPlant& plant, const PidGains& gains,
                                   const control::LoopTiming& timing) {
    const auto openLoop = control::sampledOpenLoop(plant, gains, timing);
    if (!openLoop) {
        return failure(openLoop.error());
    }
    AnalysisResult result;
    if (const auto taken = takeOpenLoop(result, *openLoop); !taken) {
        return failure(taken.error());
    }
    result.proportionalLimit_A_per_rad =
        control::proportionalLimit_A_per_rad(plant, timing, gains.derivative);
    result.highFrequencyGain_A_per_rad = gains.proportional + gains.derivative / timing.period_s;
    return result;
}

} // namespace

Result<AnalysisResult> runAnalysis(const MotorEstimate& estimate, const control::PositionLaw& law,
                                   const LoopConditions& conditions) {
    const auto plant = plantFromEstimate(estimate);
    if (!plant) {
        return failure(plant.error());
    }
    const auto gains = checkedGains(law);
    if (!gains) {
        return failure(gains.error());
    }
    if (const auto valid = checkConditions(conditions); !valid) {
        return failure(valid.error());
    }
    auto result = predictLoop(*plant, *gains, conditions.timing);
    if (!result) {
        return result;
    }
    const auto stepped =
        result->isStable ? stepLoop(*result, *plant, *gains, conditions.timing) : Result<void>{};
    const auto largeStep = predictLargeStep(*plant, law, conditions, degreesToRadians(LargeStep_deg));
    if (!stepped || !largeStep) {
        return failure(stepped ? largeStep.error() : stepped.error());
    }
    result->largeStep = *largeStep;
    result->frictionBand_rad = control::frictionBand_rad(*plant, law);
    addStabilityWarnings(*result, gains->proportional);
    const control::LoopTiming oneLater{conditions.timing.period_s, conditions.timing.delay_samples + 1};
    if (const auto later = control::sampledOpenLoop(*plant, *gains, oneLater)) {
        addDelayWarning(*result, control::poleRadius(*later));
    }
    addFrictionWarning(*result, gains->integral > 0.0);
    addStrayWarning(*result, conditions.stray);
    addSaturationNote(*result, *gains, conditions.currentLimit_A);
    result->quality.verdict = result->isStable ? Verdict::Good : Verdict::Doubtful;
    result->quality.findings = result->warnings;
    return result;
}

} // namespace halbench::app
