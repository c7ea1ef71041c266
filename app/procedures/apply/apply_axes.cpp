#include "app/procedures/apply/apply_axes.h"

#include "app/procedures/apply/gain_transaction.h"
#include "app/procedures/apply/verify_move.h"
#include "app/procedures/base/axis_choice.h"
#include "app/procedures/base/offered_procedure.h"
#include "app/procedures/base/procedure_steps.h"
#include "app/procedures/base/restored_result.h"
#include "app/procedures/tune/loop_axis.h"
#include "app/procedures/tune/position_law_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace halbench::app {
namespace {

Error ofAxis(const std::string& axis, const Error& error) {
    return {error.code, fmt::format("axis {}: {}", axis, error.message), error.hint};
}

ApplyVerification stepOf(const devices::AxisSpec& axis, const MotorEstimate& estimate, double effortLimit) {
    constexpr double Tolerance_ratio = 0.04;
    ApplyVerification verification;
    verification.axis = axis;
    verification.motor = estimate;
    verification.effortLimit = effortLimit;
    verification.reference.shape = MoveReference::Shape::Step;
    verification.reference.amplitude = loopAxisOf(axis).testStep;
    verification.errorTolerance_rad =
        std::max(Tolerance_ratio * verification.reference.amplitude, axis.endTolerance);
    verification.bandTolerance_rad = Tolerance_ratio * verification.reference.amplitude;
    return verification;
}

void judgeNeighbours(ApplyResult& assessment) {
    for (const CrossAxisPeak& other : assessment.verification->others) {
        const double allowed = crossAxisTolerance(other.axis);
        if (other.measured > allowed) {
            assessment.quality.verdict = Verdict::Refused;
            assessment.quality.findings.push_back(
                {"cross_axis_peak",
                 fmt::format("motion of axis {} meanwhile: {:.3g} {}, allowed {:.3g} {}", other.axis.id,
                             other.measured, other.axis.positionUnit, allowed, other.axis.positionUnit),
                 "Old values restored. Identify the axes again, or use lower gains."});
        }
    }
}

void addQuality(DataQuality& quality, const AxisVerification& verified) {
    quality.verdict = std::max(quality.verdict, verified.assessment.quality.verdict);
    for (const Finding& finding : verified.assessment.quality.findings) {
        quality.findings.push_back(
            {finding.code, fmt::format("axis {}: {}", verified.axis.id, finding.message), finding.hint});
    }
}

Result<void> verifyAll(devices::Device& device, const ApplyAxesConfig& config,
                       const ProcedureObserver& observer, ApplyAxesResult& result) {
    for (const ApplyVerification& verification : config.verification) {
        AxisVerification verified{*verification.axis, {}};
        if (auto seen = verifyMove(device, verification, observer, verified.assessment); !seen) {
            return failure(ofAxis(verified.axis.id, seen.error()));
        }
        judgeNeighbours(verified.assessment);
        addQuality(result.quality, verified);
        result.axes.push_back(std::move(verified));
        if (result.quality.verdict == Verdict::Refused) {
            return {};
        }
    }
    return {};
}

Result<ApplyAxesResult> runInside(devices::Device& device, const ApplyAxesConfig& config, RestoreGuard& guard,
                                  const ProcedureObserver& observer) {
    ApplyAxesResult result;
    auto changed = writeVerified(device, guard, config.values, observer);
    if (!changed) {
        return failure(changed.error());
    }
    result.before = std::move(changed->before);
    result.after = std::move(changed->after);
    if (auto verified = verifyAll(device, config, observer, result); !verified) {
        return failure(verified.error());
    }
    if (auto goOn = observer.checkAbort ? observer.checkAbort() : Result<void>(); !goOn) {
        return failure(goOn.error());
    }
    result.isKept = result.quality.verdict != Verdict::Refused;
    if (result.isKept) {
        if (auto kept = keepValues(device, guard, config.values); !kept) {
            return failure(kept.error());
        }
        guard.keep();
    }
    return result;
}

Result<ApplyAxesResult> runGuarded(devices::Device& device, const ApplyAxesConfig& config,
                                   const ProcedureObserver& observer) {
    if (auto offered = checkProcedureOffered(device.catalogue(), "apply"); !offered) {
        return failure(offered.error());
    }
    if (auto entered = enterState(observer, ProcedureState::Prepare); !entered) {
        return failure(entered.error());
    }
    if (auto checked = checkValues(device.catalogue(), config.values); !checked) {
        return failure(checked.error());
    }
    auto guard = RestoreGuard::take(device, namesOf(config.values));
    if (!guard) {
        return failure(guard.error());
    }
    if (auto entered = enterState(observer, ProcedureState::Propose); !entered) {
        return failure(entered.error());
    }
    return restoredResult(*guard, runInside(device, config, *guard, observer));
}

/// The law of one axis for its board.
Result<std::vector<ParameterValue>> valuesOf(const TuneResult& result, const devices::Catalogue& catalogue) {
    LoopLaw law(result.law, result.filtered);
    if (catalogue.parameterForRole("feedforward.inertia").empty()) {
        law.law.inertia_A_s2_rad = 0.0;
    }
    return lawForDevice(law, catalogue);
}

} // namespace

double crossAxisTolerance(const devices::AxisSpec& axis) {
    constexpr double Step_ratio = 0.05;
    return std::max(axis.endTolerance, Step_ratio * loopAxisOf(axis).testStep);
}

Result<ApplyAxesConfig> applyAxesConfig(const devices::Catalogue& catalogue, const AxisModel& model,
                                        const TuneAxesResult& result) {
    ApplyAxesConfig config;
    for (const TuneResult& tuned : result.axes) {
        const std::string& id = tuned.conditions.axis.value().id;
        const auto axis = chosenAxes(catalogue, id);
        if (!axis) {
            return failure(axis.error());
        }
        const auto values = valuesOf(tuned, catalogueOfAxis(catalogue, axis->front()));
        if (!values) {
            return failure(ofAxis(id, values.error()));
        }
        config.values.insert(config.values.end(), values->begin(), values->end());
        config.verification.push_back(
            stepOf(axis->front(), estimateOfAxis(model, *model.find(id)), tuned.conditions.currentLimit_A));
    }
    return config;
}

Result<ApplyAxesResult> runApplyAxes(devices::Device& device, const ApplyAxesConfig& config,
                                     const ProcedureObserver& observer) {
    const auto result = runGuarded(device, config, observer);
    const bool isKept = result && result->isKept;
    // The change is complete: an abort that comes now finds it done or undone, never half.
    (void)enterState(observer, isKept ? ProcedureState::Done : ProcedureState::Restored);
    return result;
}

} // namespace halbench::app
