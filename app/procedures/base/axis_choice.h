#pragma once

#include "control/base/result.h"
#include "devices/device.h"

#include <string>

namespace halbench::app {

/// The axis that is meant by `name`; an empty name is the only axis of a device. A device of which no axis is
/// known has the one of a board without a profile. Errors: Usage (several axes and none named, or all of
/// them), UnknownName; the hint lists the axes.
Result<devices::AxisSpec> chosenAxis(const devices::Catalogue& catalogue, const std::string& name);

/// Names of what plays a role; the role itself where nothing does, for boards without a profile.
std::string signalOf(const devices::Catalogue& catalogue, const std::string& role);
std::string parameterOf(const devices::Catalogue& catalogue, const std::string& role);

} // namespace halbench::app
