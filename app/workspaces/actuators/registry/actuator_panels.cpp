#include "app/workspaces/actuators/registry/actuator_panels.h"

#include "app/workspaces/actuators/spherical/estimator_panel.h"

namespace halbench::app {

const std::vector<ActuatorPanel>& actuatorPanels() {
    static const std::vector<ActuatorPanel> panels = {estimatorActuatorPanel()};
    return panels;
}

} // namespace halbench::app
