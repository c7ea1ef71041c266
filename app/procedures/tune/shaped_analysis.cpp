#include "app/procedures/tune/shaped_analysis.h"

#include "app/procedures/tune/large_step.h"
#include "app/procedures/tune/loop_prediction.h"
#include "control/assess/shaped_loop.h"
#include "control/base/assert.h"
#include "control/base/units.h"
#include "control/law/shaped_delta.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::app {

namespace {

Result<void> predictLoop(AnalysisResult& result, const control::PositionPlant& plant,
                         const control::ShapedLaw& shaped, const control::LoopTiming& timing) {
    const auto openLoop = control::deltaOpenLoop(plant, shaped, timing);
    const auto fast_A = control::shapedFastGain_A_per_rad(shaped, timing.period_s);
    const auto limit_A = control::shapedProportionalLimit_A_per_rad(plant, shaped, timing);
    auto poles = control::shapedPoles(plant, shaped, timing);
    if (!openLoop || !fast_A || !limit_A || !poles) {
        return failure(!openLoop  ? openLoop.error()
                       : !fast_A  ? fast_A.error()
                       : !limit_A ? limit_A.error()
                                  : poles.error());
    }
    result.proportionalLimit_A_per_rad = *limit_A;
    result.highFrequencyGain_A_per_rad = *fast_A;
    return takeOpenLoop(result, *openLoop, *std::move(poles));
}

Result<void> predictSteps(AnalysisResult& result, const control::PositionPlant& plant, const LoopLaw& law,
                          const LoopConditions& conditions) {
    const control::LoopTiming& timing = conditions.timing;
    if (result.isStable) {
        const auto stepped =
            takeWholeStep(result, timing.period_s, [&](double duration_s, int pointsPerSample) {
                return control::shapedStep(plant, *law.shaped, timing, 1.0, duration_s, pointsPerSample);
            });
        if (!stepped) {
            return stepped;
        }
    }
    auto large = predictLargeStep(plant, law, conditions, LargeStepHeight_rad);
    if (!large) {
        return failure(large.error());
    }
    result.largeStep = *std::move(large);
    return {};
}

void warn(AnalysisResult& result, const control::PositionPlant& plant, const LoopLaw& law,
          const LoopConditions& conditions) {
    const control::LoopTiming& timing = conditions.timing;
    addStabilityWarnings(result, law.law.gains.proportional);
    if (const auto later =
            control::shapedPoleRadius(plant, *law.shaped, {timing.period_s, timing.delay_samples + 1})) {
        addDelayWarning(result, *later);
    }
    addFrictionWarning(result, law.law.gains.integral > 0.0);
    addStrayWarning(result, conditions.stray);
    const std::vector<double>& current_A = result.stepCurve.current_A;
    if (!current_A.empty()) { // of 1 rad
        const auto [least, most] = std::minmax_element(current_A.begin(), current_A.end());
        addSaturationNote(result, std::max(std::abs(*least), std::abs(*most)), conditions.currentLimit_A);
    }
    result.warnings.push_back(
        {"needs_filtered_law", "these gains need a board whose law has their set-point weights and filters",
         "tune --gains FILE --apply DEVICE says whether it has; else save the law as C code"});
}

} // namespace

Result<AnalysisResult> analyseShaped(const control::PositionPlant& plant, const LoopLaw& given,
                                     const LoopConditions& conditions) {
    HB_ASSERT(given.shaped.has_value());
    if (const auto valid = checkConditions(conditions); !valid) {
        return failure(valid.error());
    }
    const auto law = checkedLaw(given, conditions.timing.period_s);
    if (!law) {
        return failure(law.error());
    }
    AnalysisResult result;
    if (const auto looped = predictLoop(result, plant, *law->shaped, conditions.timing); !looped) {
        return failure(looped.error());
    }
    if (const auto stepped = predictSteps(result, plant, *law, conditions); !stepped) {
        return failure(stepped.error());
    }
    result.frictionBand_rad = control::frictionBand_rad(plant, lawAtRest(*law, conditions.timing.period_s));
    warn(result, plant, *law, conditions);
    result.quality.verdict = result.isStable ? Verdict::Good : Verdict::Doubtful;
    result.quality.findings = result.warnings;
    return result;
}

} // namespace halbench::app
