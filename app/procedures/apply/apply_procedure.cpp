#include "app/procedures/apply/apply_procedure.h"

#include "app/procedures/apply/gain_transaction.h"
#include "app/procedures/apply/verify_move.h"
#include "app/procedures/base/offered_procedure.h"
#include "app/procedures/base/procedure_steps.h"
#include "app/procedures/base/restored_result.h"

namespace halbench::app {
namespace {

Result<ApplyResult> runInside(devices::Device& device, const ApplyConfig& config, RestoreGuard& guard,
                              const ProcedureObserver& observer) {
    ApplyResult result;
    auto changed = writeVerified(device, guard, config.values, observer);
    if (!changed) {
        return failure(changed.error());
    }
    result.before = std::move(changed->before);
    result.after = std::move(changed->after);
    if (config.verification) {
        if (auto verified = verifyMove(device, *config.verification, observer, result); !verified) {
            return failure(verified.error());
        }
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

Result<ApplyResult> runGuarded(devices::Device& device, const ApplyConfig& config,
                               const ProcedureObserver& observer) {
    if (auto offered = checkProcedureOffered(device.catalogue(), "apply"); !offered) {
        return failure(offered.error());
    }
    if (auto single = checkSingleLoop(device.catalogue(), "apply"); !single) {
        return failure(single.error());
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

} // namespace

ApplyVerification stepVerification(const MotorEstimate& motor) {
    ApplyVerification verification;
    verification.motor = motor;
    verification.reference.shape = MoveReference::Shape::Step;
    verification.reference.amplitude = 0.5;
    return verification;
}

MoveOutlook verificationOutlook(const ApplyVerification& verification, const devices::Catalogue& catalogue) {
    return moveOutlook(moveOf(verification), catalogue);
}

Result<ApplyResult> runApply(devices::Device& device, const ApplyConfig& config,
                             const ProcedureObserver& observer) {
    const auto result = runGuarded(device, config, observer);
    const bool isKept = result && result->isKept;
    // The change is complete: an abort that comes now finds it done or undone, never half.
    (void)enterState(observer, isKept ? ProcedureState::Done : ProcedureState::Restored);
    return result;
}

} // namespace halbench::app
