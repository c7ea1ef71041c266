#pragma once

#include "app/actuators/actuator.h"

namespace halbench::app {

/// Row of an actuator whose axes do not act on each other and need no calibration: nothing of it is its own.
Actuator independentAxes(std::string_view model, std::string_view title);

} // namespace halbench::app
