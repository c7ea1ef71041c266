#pragma once

#include "app/procedures/base/procedure.h"

namespace halbench::app {

/// Homes a board that does not know its zero. That moves nothing: it only says where the count of positions
/// begins. True: it was homed now. Errors: Refused (it cannot find its zero, or is driven), of the device, of
/// the abort.
Result<bool> awaitZero(devices::Device& device, const ProcedureObserver& observer);

/// What a result says after that: where it stood was taken for its zero cell, and no sensor can tell.
Finding homedHere();

} // namespace halbench::app
