#pragma once

#include "control/base/result.h"
#include "devices/device.h"

#include <string>

namespace halbench::app {

/// Procedures that suit a device are listed in its profile; a board without a profile lists none and is
/// judged by its signals and parameters. Error: Usage, naming the procedures of the device.
Result<void> checkProcedureOffered(const devices::Catalogue& catalogue, const std::string& procedure);

} // namespace halbench::app
