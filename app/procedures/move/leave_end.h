#pragma once

#include "app/procedures/base/procedure.h"
#include "devices/device.h"

#include <optional>

namespace halbench::app {

/// From the middle of an axis to the end of its travel: half of the widest position window that its board
/// takes, since a wider one than from end to end would never trip. Nothing of an axis that turns forever, and
/// of a board that does not say.
std::optional<double> travelOf(const devices::Catalogue& catalogue, const devices::AxisSpec& axis);

/// Steps of its own test step towards the middle, with the law that runs, until an axis that stands at the
/// end of its travel has room for such a step to either side: what is measured there would be the stop, and
/// an unbraked axis may have glided there by itself. The caller holds the RestoreGuard. Errors: of
/// performMove().
Result<void> leaveEnd(devices::Device& device, const devices::AxisSpec& axis,
                      const ProcedureObserver& observer);

} // namespace halbench::app
