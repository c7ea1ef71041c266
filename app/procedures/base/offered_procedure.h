#pragma once

#include "control/base/result.h"
#include "devices/device.h"

#include <string>

namespace halbench::app {

/// Procedures that suit a device are listed in its profile; a board without a profile lists none and is
/// judged by its signals and parameters. Error: Usage, naming the procedures of the device.
Result<void> checkProcedureOffered(const devices::Catalogue& catalogue, const std::string& procedure);
/// A procedure on the only loop of a device does not start on one with several axes. Error: likewise.
Result<void> checkSingleLoop(const devices::Catalogue& catalogue, const std::string& procedure);

/// A procedure that turns a rotor for ever needs a device of one axis that can. Error: Usage.
Result<void> checkTurnsForever(const devices::Catalogue& catalogue);

} // namespace halbench::app
