#pragma once

#include "app/procedures/analyse.h"
#include "app/procedures/move_procedure.h"
#include "app/procedures/procedure.h"

#include <optional>
#include <vector>

namespace halbench::app {

/// How new gains prove themselves before they stay.
struct ApplyVerification {
    MoveReference reference;
    double duration_s = 3.0;
    MotorEstimate motor; ///< for the prediction of the ideal loop; needs c_over_J, Kf_over_J, phi_over_J or
                         ///< J, c, Kf, phi
    double overshootTolerance_percent = 8.0; ///< measured may exceed the prediction by this
    double errorTolerance_rad = 0.02;        ///< final error, likewise
};

struct ApplyConfig {
    std::vector<ParameterValue> values;
    std::optional<ApplyVerification> verification;
};

struct ApplyResult {
    std::vector<ParameterValue> before;
    std::vector<ParameterValue> after; ///< as read back
    std::optional<MoveFigures> predicted;
    std::optional<MoveResult> verification;
    bool isKept = false; ///< false: the old values run again, `quality` says why
    DataQuality quality;
};

/// One transaction: snapshot, range and finite checks, write, read back, verification move, keep or restore.
/// Walks Prepare, Propose, Apply, Verify, Done or Restored. Errors: UnknownName, NotFinite, OutOfRange
/// (before the first byte is sent), of the device, of the abort; the old values run again after each of them.
Result<ApplyResult> runApply(devices::Device& device, const ApplyConfig& config,
                             const ProcedureObserver& observer);

} // namespace halbench::app
