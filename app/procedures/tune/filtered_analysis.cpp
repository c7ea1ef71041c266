#include "app/procedures/tune/filtered_analysis.h"

#include "app/procedures/tune/large_step.h"
#include "app/procedures/tune/loop_axis.h"
#include "app/procedures/tune/loop_prediction.h"
#include "control/assess/filtered_loop.h"
#include "control/base/assert.h"
#include "control/base/units.h"
#include "control/law/filtered_delta.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::app {

namespace {

Result<void> predictLoop(AnalysisResult& result, const control::PositionPlant& plant,
                         const control::FilteredLaw& filtered, const control::LoopTiming& timing) {
    const auto openLoop = control::deltaOpenLoop(plant, filtered, timing);
    const auto fast_A = control::filteredFastGain_A_per_rad(filtered, timing.period_s);
    const auto limit_A = control::filteredProportionalLimit_A_per_rad(plant, filtered, timing);
    auto poles = control::filteredPoles(plant, filtered, timing);
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
                return control::filteredStep(plant, *law.filtered, timing, 1.0, duration_s, pointsPerSample);
            });
        if (!stepped) {
            return stepped;
        }
    }
    auto large = predictLargeStep(plant, law, conditions, largeStepHeight(conditions));
    if (!large) {
        return failure(large.error());
    }
    result.largeStep = *std::move(large);
    return {};
}

void warn(AnalysisResult& result, const control::PositionPlant& plant, const LoopLaw& law,
          const LoopConditions& conditions) {
    const control::LoopTiming& timing = conditions.timing;
    const auto later =
        control::filteredPoleRadius(plant, *law.filtered, {timing.period_s, timing.delay_samples + 1});
    if (conditions.axis) { // of its board, which is asked when the gains are written
        addAxisWarnings(result, *conditions.axis, conditions.currentLimit_A,
                        later ? std::optional(*later) : std::nullopt);
        return;
    }
    addStabilityWarnings(result, law.law.gains.proportional);
    if (later) {
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
        {"needs_filtered_law",
         "these gains need a device whose control law has set-point weights and filters",
         "check with tune --gains FILE --apply DEVICE; otherwise save the control law as C code"});
}

} // namespace

Result<AnalysisResult> analyseFiltered(const control::PositionPlant& plant, const LoopLaw& given,
                                       const LoopConditions& conditions) {
    HB_ASSERT(given.filtered.has_value());
    if (const auto valid = checkConditions(conditions); !valid) {
        return failure(valid.error());
    }
    const auto law = checkedLaw(given, conditions.timing.period_s);
    if (!law) {
        return failure(law.error());
    }
    AnalysisResult result;
    if (const auto looped = predictLoop(result, plant, *law->filtered, conditions.timing); !looped) {
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
