#pragma once

#include "app/actuators/actuator.h"

namespace halbench::app {

/// Row of the motor: one axis that turns for ever.
Actuator motorActuator();

} // namespace halbench::app
