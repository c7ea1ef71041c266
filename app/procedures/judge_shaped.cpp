#include "app/procedures/judge_shaped.h"

#include "app/procedures/loop_prediction.h"
#include "control/base/random.h"
#include "control/design/shaped_loop.h"

#include <algorithm>
#include <array>
#include <utility>

namespace halbench::app {

namespace {

/// What friction and integral see at rest: there the filters are their gain for a constant.
control::PositionLaw atRest(control::PositionLaw law, const control::ShapedLaw& shaped, double period_s) {
    const auto filters = control::filtersInSeries(shaped.filters, period_s);
    const double gain_ratio = filters ? filters->dcGain() : 1.0;
    law.gains.proportional *= gain_ratio;
    law.gains.integral *= gain_ratio;
    law.gains.filter_s.reset(); // at rest nothing moves
    return law;
}

Result<void> predict(TuneResult& result, const control::ShapedLaw& shaped) {
    const control::LoopTiming& timing = result.conditions.timing;
    const auto openLoop = control::shapedOpenLoop(result.plant, shaped, timing);
    if (!openLoop) {
        return failure(openLoop.error());
    }
    AnalysisResult& predicted = result.predicted;
    if (const auto taken = takeOpenLoop(predicted, *openLoop); !taken) {
        return taken;
    }
    const double limit_A = result.conditions.currentLimit_A;
    auto proof = control::proveShaped(result.plant, shaped, timing, limit_A);
    if (!proof) {
        return predicted.isStable ? failure(proof.error()) : Result<void>(); // grows beyond all numbers
    }
    predicted.proportionalLimit_A_per_rad = proof->proportionalLimit_A_per_rad;
    predicted.highFrequencyGain_A_per_rad = proof->fastGain_A_per_rad;
    if (predicted.isStable) {
        auto step = control::shapedStep(result.plant, shaped, timing, 1.0,
                                        stepDuration_s(predicted, timing.period_s));
        if (!step) {
            return failure(step.error());
        }
        takeStep(predicted, *std::move(step));
    }
    result.proof = *std::move(proof);
    return {};
}

void warn(TuneResult& result, bool isUncertain) {
    AnalysisResult& predicted = result.predicted;
    const control::PidGains& gains = result.law.gains;
    addStabilityWarnings(predicted, gains.proportional);
    if (result.proof) {
        addDelayWarning(predicted, result.proof->poleRadiusOneSampleLater);
    }
    addFrictionWarning(predicted, gains.integral > 0.0);
    addStrayWarning(predicted, result.conditions.stray);
    predicted.warnings.push_back(
        {"not_on_board",
         "the board's law has no set-point weights and no filters: this loop is judged and cannot be applied",
         "limit cycles, large steps and loads are not predicted for it"});
    addRobustnessWarnings(predicted.warnings, result.robust, predicted.isStable, isUncertain);
    predicted.quality.findings = predicted.warnings;
    result.warnings = predicted.warnings;
}

void judge(TuneResult& result) {
    static constexpr std::array Doubts = {"not_robust", "small_margin", "stray_field_error",
                                          "stray_field_not_compensated"};
    const bool isDoubtful =
        std::any_of(result.warnings.begin(), result.warnings.end(), [](const Finding& finding) {
            return std::find(Doubts.begin(), Doubts.end(), finding.code) != Doubts.end();
        });
    const bool isStable = result.predicted.isStable;
    result.predicted.quality.verdict = isStable ? Verdict::Good : Verdict::Doubtful;
    result.quality.verdict = !isStable ? Verdict::Refused : isDoubtful ? Verdict::Doubtful : Verdict::Good;
    result.quality.findings = result.warnings;
}

} // namespace

Result<TuneResult> judgeShaped(const MotorEstimate& estimate, const control::ShapedLaw& shaped,
                               const control::PositionLaw& extras, const TuneConfig& config) {
    const auto plant = plantFromEstimate(estimate);
    const auto uncertain = uncertainPlantFromEstimate(estimate);
    if (!plant || !uncertain) {
        return failure(plant ? uncertain.error() : plant.error());
    }
    if (const auto valid = checkConditions(config.conditions); !valid) {
        return failure(valid.error());
    }
    const auto gains = control::checkedGains(shaped, config.conditions.timing.period_s);
    const auto positive = gains ? checkPositionGains(*gains) : failure(gains.error());
    if (!positive) {
        return failure(positive.error());
    }
    TuneResult result;
    result.method = config.method;
    result.targets = config.targets;
    result.conditions = config.conditions;
    result.plant = *plant;
    result.law = extras;
    result.law.gains = *gains;
    if (const auto predicted = predict(result, shaped); !predicted) {
        return failure(predicted.error());
    }
    const control::PositionLaw resting = atRest(result.law, shaped, config.conditions.timing.period_s);
    result.predicted.frictionBand_rad = control::frictionBand_rad(*plant, resting);
    result.release_s = releaseTime_s(*plant, resting, result.predicted.frictionBand_rad);
    const auto robust = control::assessShaped(*uncertain, shaped, config.conditions.timing, config.draws,
                                              Random(config.seed));
    if (!robust) {
        return failure(robust.error());
    }
    result.robust = *robust;
    warn(result, !estimate.covarianceNames.empty());
    judge(result);
    return result;
}

} // namespace halbench::app
