#pragma once

#include "app/procedures/apply/apply_procedure.h"
#include "app/procedures/apply/live_apply_plan.h"

#include <vector>

namespace halbench::app {

/// One step that was written.
struct LiveStepResult {
    std::vector<ParameterValue> values; ///< as read back
    control::Robustness robust;         ///< predicted before it was written
    double widening_ratio = 0.0;        ///< of its band, that the measured motion needs; up to 1 is inside
    bool isWithin = false;
};

struct LiveApplyResult {
    ApplyResult apply; ///< of the whole: before, the last values, the last verification, kept or not
    std::vector<LiveStepResult> steps;
    std::size_t plannedSteps = 0;
};

/// From the gains that run to others in small steps. All of them are judged before the first is written; then
/// each is written as one transaction, read back and proved by a move, which ends as soon as the measured
/// angle leaves the predicted band. When it does, and on every other way out (abort, fault, lost link, bad
/// data), the gains from before all of it run again, read back. Walks Prepare, Propose, then Apply and Verify
/// for each step, Done or Restored. A motion that leaves its band is a result that is not kept. Errors:
/// Refused (a set on the way is not safe); UnknownName, NotFinite, OutOfRange (before the first byte is
/// sent), of the device, of the abort.
Result<LiveApplyResult> runLiveApply(devices::Device& device, const LiveApplyConfig& config,
                                     const ProcedureObserver& observer);

/// How far and how long the rotor moves with each step; the way is as long as runLiveApply() will go.
MoveOutlook liveStepOutlook(const LiveApplyConfig& config, const devices::Catalogue& catalogue);

} // namespace halbench::app
