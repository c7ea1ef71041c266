#pragma once

#include "app/procedures/excite/spin_drive.h"

#include <span>

namespace halbench::app {

/// Records `signals` at 100 1/s while the plateaus of `runs` are driven one after the other, guarded from the
/// host as well: beyond `speedLimit_rad_s` or the device's own limits the board is stopped first.
/// Errors: those of runPlateaus and of the guard, and a recording with lost rows.
Result<Recording> recordSpin(devices::Device& device, const ProcedureObserver& observer,
                             std::span<const PlateauRun> runs, double speedLimit_rad_s,
                             const std::vector<std::string>& signals);

} // namespace halbench::app
