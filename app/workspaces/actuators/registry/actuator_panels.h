#pragma once

#include "app/workspaces/actuators/actuator_panel.h"

#include <vector>

namespace halbench::app {

/// The panels of all kinds of actuators, in the order in which they are docked.
const std::vector<ActuatorPanel>& actuatorPanels();

} // namespace halbench::app
