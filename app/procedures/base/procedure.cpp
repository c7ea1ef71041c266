#include "app/procedures/base/procedure.h"

namespace halbench::app {

std::string_view procedureStateName(ProcedureState state) {
    switch (state) {
    case ProcedureState::Prepare:
        return "prepare";
    case ProcedureState::Excite:
        return "excite";
    case ProcedureState::Record:
        return "record";
    case ProcedureState::Fit:
        return "fit";
    case ProcedureState::Judge:
        return "judge";
    case ProcedureState::Propose:
        return "propose";
    case ProcedureState::Apply:
        return "apply";
    case ProcedureState::Verify:
        return "verify";
    case ProcedureState::Done:
        return "done";
    case ProcedureState::Restored:
        return "restored";
    }
    return "unknown";
}

std::string_view verdictName(Verdict verdict) {
    switch (verdict) {
    case Verdict::Good:
        return "good";
    case Verdict::Doubtful:
        return "doubtful";
    case Verdict::Refused:
        return "refused";
    }
    return "refused";
}

ProcedureObserver listeningIn(const ProcedureObserver& observer,
                              std::function<void(const SampleBlock&)> take) {
    ProcedureObserver listening = observer;
    listening.onBlock = [take = std::move(take), next = observer.onBlock](const SampleBlockPtr& block) {
        take(*block);
        if (next) {
            next(block);
        }
    };
    return listening;
}

} // namespace halbench::app
