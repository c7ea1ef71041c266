#pragma once

#include "app/procedures/base/procedure.h"
#include "devices/axis_spec.h"

namespace halbench::app {

/// Waits for an axis without drive until it stands still: one that coasts would give the next reference a
/// moving origin. An axis that does not stop (no friction) is waited for 10 s and taken as it is; one whose
/// speed is not reported is not waited for. Errors: of the device, of checkAbort.
Result<void> awaitStandstill(devices::Device& device, const devices::AxisSpec& axis,
                             const ProcedureObserver& observer);

} // namespace halbench::app
