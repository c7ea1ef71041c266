#pragma once

#include "control/base/result.h"
#include "devices/device.h"

#include <string>
#include <vector>

namespace halbench::app {

/// The axes of a device; of one of which none is known, the one axis of a board without a profile.
std::vector<devices::AxisSpec> axesOf(const devices::Catalogue& catalogue);

/// The axis that is meant by `name`; an empty name is the only axis of a device. A device of which no axis is
/// known has the one of a board without a profile. Errors: Usage (several axes and none named, or all of
/// them), UnknownName; the hint lists the axes.
Result<devices::AxisSpec> chosenAxis(const devices::Catalogue& catalogue, const std::string& name);

/// The axes that are meant by `name`: all of them for "all" or an empty name. Error: UnknownName; the hint
/// lists the axes.
Result<std::vector<devices::AxisSpec>> chosenAxes(const devices::Catalogue& catalogue,
                                                  const std::string& name);

/// The catalogue as it would be if this were the only axis of the device: its roles are the bare ones
/// ("gain.kp", "filter.1.b0", "position"), and those of the other axes are none.
devices::Catalogue catalogueOfAxis(const devices::Catalogue& catalogue, const devices::AxisSpec& axis);

/// Names of what plays a role; the role itself where nothing does, for boards without a profile.
std::string signalOf(const devices::Catalogue& catalogue, const std::string& role);
std::string parameterOf(const devices::Catalogue& catalogue, const std::string& role);

} // namespace halbench::app
