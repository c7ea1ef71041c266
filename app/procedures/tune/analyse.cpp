#include "app/procedures/tune/analyse.h"

#include "app/procedures/base/doubtful_source.h"
#include "app/procedures/tune/filtered_analysis.h"
#include "app/procedures/tune/large_step.h"
#include "app/procedures/tune/loop_axis.h"
#include "app/procedures/tune/loop_prediction.h"
#include "control/law/filtered_delta.h"

#include <algorithm>

namespace halbench::app {

namespace {

using control::PidGains;

Result<void> stepLoop(AnalysisResult& result, const control::PositionPlant& plant, const PidGains& gains,
                      const control::LoopTiming& timing) {
    return takeWholeStep(result, timing.period_s, [&](double duration_s, int pointsPerSample) {
        return control::linearStep(plant, gains, timing, 1.0, duration_s, pointsPerSample);
    });
}

/// Everything that the open loop tells.
Result<AnalysisResult> predictLoop(const control::PositionPlant& plant, const PidGains& gains,
                                   const control::LoopTiming& timing) {
    const auto openLoop = control::sampledOpenLoop(plant, gains, timing);
    if (!openLoop) {
        return failure(openLoop.error());
    }
    control::FilteredLaw law;
    law.gains = gains;
    const auto factors = control::deltaOpenLoop(plant, law, timing);
    if (!factors) {
        return failure(factors.error());
    }
    AnalysisResult result;
    if (const auto taken = takeOpenLoop(result, *factors, control::closedLoopPoles(*openLoop)); !taken) {
        return failure(taken.error());
    }
    result.proportionalLimit_A_per_rad =
        control::proportionalLimit_A_per_rad(plant, timing, gains.derivative);
    result.highFrequencyGain_A_per_rad = gains.proportional + gains.derivative / timing.period_s;
    return result;
}

void addMotorWarnings(AnalysisResult& result, const PidGains& gains, const LoopConditions& conditions,
                      std::optional<double> later) {
    addStabilityWarnings(result, gains.proportional);
    if (later) {
        addDelayWarning(result, *later);
    }
    addFrictionWarning(result, gains.integral > 0.0);
    addStrayWarning(result, conditions.stray);
    addSaturationNote(result, std::max(gains.proportional, peakCurrent_A(result.stepCurve)),
                      conditions.currentLimit_A);
}

Result<AnalysisResult> analyseBoard(const control::PositionPlant& plant, const control::PositionLaw& given,
                                    const LoopConditions& conditions) {
    const auto checked = checkedLaw(given, conditions.timing.period_s);
    if (!checked) {
        return failure(checked.error());
    }
    if (const auto valid = checkConditions(conditions); !valid) {
        return failure(valid.error());
    }
    const PidGains& gains = checked->law.gains;
    auto result = predictLoop(plant, gains, conditions.timing);
    if (!result) {
        return result;
    }
    const auto stepped =
        result->isStable ? stepLoop(*result, plant, gains, conditions.timing) : Result<void>{};
    const auto largeStep = predictLargeStep(plant, given, conditions, largeStepHeight(conditions));
    if (!stepped || !largeStep) {
        return failure(stepped ? largeStep.error() : stepped.error());
    }
    result->largeStep = *largeStep;
    result->frictionBand_rad = control::frictionBand_rad(plant, given);
    const control::LoopTiming oneLater{conditions.timing.period_s, conditions.timing.delay_samples + 1};
    const auto later = control::sampledOpenLoop(plant, gains, oneLater);
    const auto laterRadius = later ? std::optional(control::poleRadius(*later)) : std::nullopt;
    if (conditions.axis) {
        addAxisWarnings(*result, *conditions.axis, conditions.currentLimit_A, laterRadius);
    } else {
        addMotorWarnings(*result, gains, conditions, laterRadius);
    }
    result->quality.verdict = result->isStable ? Verdict::Good : Verdict::Doubtful;
    result->quality.findings = result->warnings;
    return result;
}

} // namespace

Result<AnalysisResult> runAnalysis(const MotorEstimate& estimate, const LoopLaw& law,
                                   const LoopConditions& conditions) {
    const auto plant = plantFromEstimate(estimate);
    if (!plant) {
        return failure(plant.error());
    }
    auto result =
        law.filtered ? analyseFiltered(*plant, law, conditions) : analyseBoard(*plant, law.law, conditions);
    if (result) {
        for (const auto& doubts : {estimate.doubts, conditions.doubts}) {
            addDoubts(result->quality, doubts);
            result->warnings.insert(result->warnings.end(), doubts.begin(), doubts.end());
        }
    }
    return result;
}

} // namespace halbench::app
