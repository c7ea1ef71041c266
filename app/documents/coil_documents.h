#pragma once

#include "app/documents/text/json_value.h"
#include "app/procedures/base/coil_temperature_monitor.h"

#include <string>
#include <vector>

namespace halbench::app {

/// `coil_forecast` of a recording (resources/help/command-line.md, "Results").
JsonValue toJson(const std::vector<CoilForecast>& coils);

/// One line on the coil that is to be said first; nothing when none comes near its limit, or it is not known.
std::string coilLine(const std::vector<CoilForecast>& coils);

} // namespace halbench::app
