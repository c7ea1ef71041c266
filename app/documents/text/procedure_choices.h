#pragma once

#include "app/procedures/calibrate/calibrate_procedure.h"
#include "app/procedures/identify/identify_procedure.h"

#include <string>
#include <vector>

namespace halbench::app {

/// "both", "forward", "reverse". Error: Usage.
Result<SweepDirections> sweepDirections(const std::string& name);
/// "hall", "stray", "static-friction", "all". Error: Usage.
Result<std::vector<Calibration>> calibrationsFrom(const std::string& name);

} // namespace halbench::app
