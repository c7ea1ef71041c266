#include "app/procedures/tune/analyse.h"

#include "app/procedures/tune/large_step.h"
#include "app/procedures/tune/loop_prediction.h"
#include "app/procedures/tune/shaped_analysis.h"
#include "control/law/shaped_delta.h"

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
    control::ShapedLaw law;
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
    const auto largeStep = predictLargeStep(plant, given, conditions, LargeStepHeight_rad);
    if (!stepped || !largeStep) {
        return failure(stepped ? largeStep.error() : stepped.error());
    }
    result->largeStep = *largeStep;
    result->frictionBand_rad = control::frictionBand_rad(plant, given);
    addStabilityWarnings(*result, gains.proportional);
    const control::LoopTiming oneLater{conditions.timing.period_s, conditions.timing.delay_samples + 1};
    if (const auto later = control::sampledOpenLoop(plant, gains, oneLater)) {
        addDelayWarning(*result, control::poleRadius(*later));
    }
    addFrictionWarning(*result, gains.integral > 0.0);
    addStrayWarning(*result, conditions.stray);
    addSaturationNote(*result, std::max(gains.proportional, peakCurrent_A(result->stepCurve)),
                      conditions.currentLimit_A);
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
    return law.shaped ? analyseShaped(*plant, law, conditions) : analyseBoard(*plant, law.law, conditions);
}

} // namespace halbench::app
