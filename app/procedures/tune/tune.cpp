#include "app/procedures/tune/tune.h"

#include "app/procedures/tune/loop_axis.h"
#include "app/procedures/tune/loop_prediction.h"
#include "app/procedures/tune/loop_uncertainty.h"
#include "control/assess/filtered_loop.h"
#include "control/base/random.h"
#include "control/design/axis_designs.h"
#include "control/law/board_gains.h"
#include "control/robustness/filtered_robustness.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace halbench::app {

namespace {

using control::PositionLaw;

/// One number of the law, its name on the board, and the number without which it has no effect.
struct LawField {
    const char* name;
    double& (*in)(PositionLaw&);
    const char* carrier;

    double of(PositionLaw law) const { return in(law); }
};

const std::array LawFields = {
    LawField{"gain.kp", [](PositionLaw& law) -> double& { return law.gains.proportional; }, "gain.kp"},
    LawField{"gain.ki", [](PositionLaw& law) -> double& { return law.gains.integral; }, "gain.ki"},
    LawField{"gain.kd", [](PositionLaw& law) -> double& { return law.gains.derivative; }, "gain.kd"},
    LawField{"feedforward.inertia", [](PositionLaw& law) -> double& { return law.inertia_A_s2_rad; },
             "feedforward.inertia"},
    LawField{"feedforward.viscous", [](PositionLaw& law) -> double& { return law.viscous_A_s_rad; },
             "feedforward.viscous"},
    LawField{"feedforward.coulomb", [](PositionLaw& law) -> double& { return law.coulomb_A; },
             "feedforward.coulomb"},
    LawField{"feedforward.coulomb_speed", [](PositionLaw& law) -> double& { return law.coulombSpeed_rad_s; },
             "feedforward.coulomb"},
    LawField{"stiction.current", [](PositionLaw& law) -> double& { return law.stictionCurrent_A; },
             "stiction.current"},
    LawField{"stiction.threshold", [](PositionLaw& law) -> double& { return law.stictionThreshold_rad; },
             "stiction.current"},
    LawField{"stiction.speed", [](PositionLaw& law) -> double& { return law.stictionSpeed_rad_s; },
             "stiction.current"}};

const LawField& field(std::string_view name) {
    return *std::find_if(LawFields.begin(), LawFields.end(),
                         [name](const LawField& f) { return f.name == name; });
}

/// The law in the board's notation.
Result<PositionLaw> onBoard(PositionLaw law) {
    const auto gains = control::boardGains(law.gains);
    if (!gains) {
        return failure(gains.error());
    }
    law.gains = *gains;
    for (const LawField& number : LawFields) {
        if (!std::isfinite(number.of(law))) {
            return failure(ErrorCode::NotFinite, fmt::format("{} is not a finite number", number.name),
                           "nothing was written");
        }
    }
    return law;
}

bool isPreset(const std::string& method) {
    return method == "published" || method == "designed" || method == "micro-step" ||
           method == "published-degrees" || method == "published-in-degrees";
}

void addDesignWarnings(TuneResult& result) {
    if (result.method == "published") {
        // help: htm-theory.md 6.4, 6.5
        const auto designed = control::designLaw("designed", result.plant, result.conditions.timing, {});
        if (designed) {
            result.warnings.push_back(
                {"published_gains_contradict",
                 fmt::format("the targets of the source (zeta 0.06 at 15 rad/s) give {:.4g} A/rad and {:.4g} "
                             "A/(rad s) on this motor, not the printed 10 and 0.1",
                             designed->gains.proportional, designed->gains.integral),
                 "use method designed for these gains"});
        }
    }
    const bool wantsDerivative = result.method == "recommended" || result.method == "bandwidth";
    if (wantsDerivative && result.law.gains.derivative == 0.0) {
        result.warnings.push_back({"no_derivative", "the motor's damping exceeds the target: K_D is zero",
                                   "a faster loop may be possible: method bandwidth or phase-margin"});
    }
}

void judge(TuneResult& result) {
    const auto has = [&result](std::string_view code) {
        return std::any_of(result.warnings.begin(), result.warnings.end(),
                           [code](const Finding& finding) { return finding.code == code; });
    };
    if (!result.predicted.isStable) {
        // A preset was asked for by name and shows what the theory says of it; a design must be stable.
        const bool isShown = isPreset(result.method) && !result.filtered;
        result.quality.verdict = isShown ? Verdict::Doubtful : Verdict::Refused;
    } else if (has("not_robust") || has("small_margin") || has("stray_field_error") ||
               has("stray_field_not_compensated") || has("doubtful_model") || has("doubtful_calibration") ||
               has("doubtful_relay")) {
        result.quality.verdict = Verdict::Doubtful;
    }
    result.quality.findings = result.warnings;
}

/// Of gains that say they come from such a method, also when they were read from a file.
std::optional<control::LeastErrorBounds> boundsOf(const TuneResult& result) {
    const auto measure = control::leastErrorMeasure(result.method);
    const auto targets = targetsOnBoard(result.method, result.targets, result.conditions);
    if (!measure || !targets || !result.assessment) {
        return std::nullopt;
    }
    return control::boundsOf(*result.assessment, control::leastErrorTargets(*measure, *targets),
                             *targets->currentLimit_A);
}

/// The proof looks at 2 s of a step; a current that rises slowly is highest later.
void takeWholeCurrent(control::LoopAssessment& assessment, const AnalysisResult& predicted, double limit_A) {
    if (!predicted.isStable) {
        return;
    }
    assessment.peakCurrent_A = predicted.step
                                   ? std::max(assessment.peakCurrent_A, peakCurrent_A(predicted.stepCurve))
                                   : std::numeric_limits<double>::infinity(); // not known: no step is safe
    assessment.largestStep_rad = limit_A / assessment.peakCurrent_A;
}

/// The law is there; prediction, robustness and verdict follow.
Result<TuneResult> judged(TuneResult result, const MotorEstimate& estimate, const TuneConfig& config,
                          const control::UncertainPlant& uncertain) {
    const LoopLaw law(result.law, result.filtered);
    auto predicted = runAnalysis(estimate, law, config.conditions);
    if (!predicted) {
        return failure(predicted.error());
    }
    result.predicted = std::move(*predicted);
    const control::LoopTiming& timing = config.conditions.timing;
    const Random random(config.seed);
    const auto robust =
        law.filtered ? control::assessFiltered(uncertain, *law.filtered, timing, config.draws, random)
                     : control::assessRobustness(uncertain, law.law.gains, timing, config.draws, random);
    if (!robust) {
        return failure(robust.error());
    }
    result.robust = *robust;
    if (!result.predicted
             .stableGains) { // no factor leads to stability: draws near this motor have none either
        result.robust.gainMargin_ratio.reset();
        result.robust.gainMargin_ratio_p5.reset();
    }
    // Here, on the worker that judges: whoever writes or compares results must not compute.
    const double limit_A = config.conditions.currentLimit_A;
    if (auto assessment = law.filtered
                              ? control::assessFilteredDesign(result.plant, *law.filtered, timing, limit_A)
                              : control::assessDesign(result.plant, law.law.gains, timing, limit_A)) {
        result.assessment = *std::move(assessment);
        takeWholeCurrent(*result.assessment, result.predicted, limit_A);
    }
    const auto plants = drawnPlants(estimate, {config.draws, config.seed});
    result.disturbance = disturbanceOf(estimate, law, config.conditions, result.predicted, config.load_A,
                                       plants ? *plants : std::vector<control::PositionPlant>());
    result.bounds = boundsOf(result);
    result.cycles = predictCycles(result.plant, law, config.conditions);
    result.release_s =
        releaseTime_s(result.plant, lawAtRest(law, timing.period_s), result.predicted.frictionBand_rad);
    result.warnings = result.predicted.warnings;
    const bool hasCovariance = !estimate.covarianceNames.empty();
    if (config.conditions.axis) {
        addAxisRobustness(result.warnings, result.robust, result.predicted.isStable, hasCovariance);
    } else {
        if (auto warning = cycleWarning(result.cycles.value_or(std::vector<PredictedCycle>()))) {
            result.warnings.push_back(*std::move(warning));
        }
        addDesignWarnings(result);
        addRobustnessWarnings(result.warnings, result.robust, result.predicted.isStable, hasCovariance);
    }
    judge(result);
    return result;
}

Result<LoopLaw> motorDesign(const control::PositionPlant& plant, const TuneConfig& config) {
    const auto targets = targetsOnBoard(config.method, config.targets, config.conditions);
    if (!targets) {
        return failure(targets.error());
    }
    auto law = control::designLaw(config.method, plant, config.conditions.timing, *targets);
    law = law ? onBoard(*law) : law;
    return law ? Result<LoopLaw>(LoopLaw(*law)) : failure(law.error());
}

/// With the effort that a smooth reference needs; steps do not see it.
Result<LoopLaw> axisDesign(const control::PositionPlant& plant, const TuneConfig& config) {
    const control::LoopTiming& timing = config.conditions.timing;
    auto filtered = control::designAxisLaw(config.method, plant, timing, config.targets,
                                           config.conditions.axis->designFrequency_rad_s);
    if (!filtered) {
        return failure(filtered.error());
    }
    PositionLaw law;
    law.gains = filtered->gains;
    law.inertia_A_s2_rad = 1.0 / plant.accelerationGain_rad_s2_A;
    if (control::isBoardLaw(*filtered)) {
        const auto board = onBoard(law);
        return board ? Result<LoopLaw>(LoopLaw(*board)) : failure(board.error());
    }
    return checkedLaw(LoopLaw(law, *std::move(filtered)), timing.period_s);
}

TuneResult undesigned(const MotorEstimate& estimate, const TuneConfig& config) {
    TuneResult result;
    result.method = config.method;
    result.targets = config.targets;
    result.conditions = config.conditions;
    result.plant = *plantFromEstimate(estimate); // uncertainPlantFromEstimate has judged it
    return result;
}

} // namespace

Result<control::DesignTargets> targetsOnBoard(const std::string& method, control::DesignTargets targets,
                                              const LoopConditions& conditions) {
    if (!control::readsTarget(method, "current-limit-a")) {
        return targets;
    }
    const double board_A = conditions.currentLimit_A;
    if (targets.currentLimit_A.value_or(board_A) > board_A) {
        return failure(
            ErrorCode::OutOfRange,
            fmt::format("the target current-limit-a = {:.4g} is above the device limit of {:.4g} A",
                        *targets.currentLimit_A, board_A),
            "use a lower value, or omit it");
    }
    targets.currentLimit_A = targets.currentLimit_A.value_or(board_A);
    return targets;
}

Result<TuneResult> judgeLaw(const MotorEstimate& estimate, const LoopLaw& law, const TuneConfig& config) {
    const auto uncertain = uncertainPlantFromEstimate(estimate);
    if (!uncertain) {
        return failure(uncertain.error());
    }
    const auto filtered = law.filtered ? checkedLaw(law, config.conditions.timing.period_s) : law;
    const auto board = filtered ? onBoard(filtered->law) : failure(filtered.error());
    if (!board) {
        return failure(board.error());
    }
    TuneResult result = undesigned(estimate, config);
    result.law = *board;
    result.filtered = filtered->filtered;
    return judged(std::move(result), estimate, config, *uncertain);
}

Result<TuneResult> runTune(const MotorEstimate& estimate, const TuneConfig& config) {
    const auto uncertain = uncertainPlantFromEstimate(estimate);
    if (!uncertain) {
        return failure(uncertain.error());
    }
    TuneResult result = undesigned(estimate, config);
    const auto law =
        config.conditions.axis ? axisDesign(result.plant, config) : motorDesign(result.plant, config);
    if (!law) {
        return failure(law.error());
    }
    result.law = law->law;
    result.filtered = law->filtered;
    return judged(std::move(result), estimate, config, *uncertain);
}

std::vector<ParameterValue> lawParameters(const control::PositionLaw& law) {
    const auto board = onBoard(law);
    std::vector<ParameterValue> result;
    result.reserve(LawFields.size());
    for (const LawField& number : LawFields) {
        result.push_back({number.name, number.of(board ? *board : law)});
    }
    return result;
}

bool isSameLaw(const PositionLaw& one, const PositionLaw& other) {
    const auto ones = lawParameters(one);
    const auto others = lawParameters(other);
    return std::equal(ones.begin(), ones.end(), others.begin(), others.end(),
                      [](const ParameterValue& a, const ParameterValue& b) {
                          return std::fabs(a.value - b.value) <= 1e-6 * std::fabs(a.value) + 1e-12;
                      });
}

Result<control::PositionLaw> lawFromParameters(const std::map<std::string, double>& values) {
    PositionLaw law;
    for (const LawField& number : LawFields) {
        const auto found = values.find(number.name);
        const std::string_view name = number.name;
        if (found == values.end()) {
            if (name.starts_with("gain.")) {
                return failure(ErrorCode::UnknownName, fmt::format("the set of gains lacks {}", name));
            }
            continue;
        }
        if (!std::isfinite(found->second)) {
            return failure(ErrorCode::NotFinite, fmt::format("{} is not a finite number", name));
        }
        if (found->second < 0.0) {
            return failure(ErrorCode::OutOfRange, fmt::format("{} = {} is negative", name, found->second));
        }
        number.in(law) = found->second;
    }
    return law;
}

Result<std::vector<ParameterValue>> lawForDevice(const control::PositionLaw& law,
                                                 const devices::Catalogue& catalogue) {
    const auto board = onBoard(law);
    if (!board) {
        return failure(board.error());
    }
    std::vector<ParameterValue> result;
    for (const LawField& number : LawFields) {
        const std::string byRole = catalogue.parameterForRole(number.name);
        const ParameterSpec* spec = catalogue.findParameter(byRole.empty() ? number.name : byRole);
        if (spec == nullptr) {
            if (field(number.carrier).of(*board) == 0.0) {
                continue;
            }
            return failure(
                ErrorCode::UnknownName,
                fmt::format("the device has no parameter {}, which this set of gains needs", number.name),
                "choose a method without it: pole-placement or a preset");
        }
        const double value = number.of(*board);
        if (const auto valid = checkParameterValue(*spec, value); !valid) {
            return failure(valid.error());
        }
        result.push_back({spec->name, value});
    }
    return result;
}

} // namespace halbench::app
