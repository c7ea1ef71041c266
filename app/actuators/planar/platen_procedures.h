#pragma once

#include "app/actuators/actuator.h"

namespace halbench::app {

/// Row of the positioner with six coils and three axes.
Actuator platenActuator();

} // namespace halbench::app
