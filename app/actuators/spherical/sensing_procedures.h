#pragma once

#include "app/actuators/actuator.h"

namespace halbench::app {

/// The spherical motor's orientation sensing: calibrated, never driven.
Actuator sensingActuator();

} // namespace halbench::app
