#include "app/workspaces/actuators/registry/actuator_panels.h"

#include "app/workspaces/actuators/spherical/angle_error_panel.h"
#include "app/workspaces/actuators/spherical/coverage_panel.h"
#include "app/workspaces/actuators/spherical/estimator_panel.h"

namespace halbench::app {

const std::vector<ActuatorPanel>& actuatorPanels() {
    static const std::vector<ActuatorPanel> panels = {coverageActuatorPanel(), estimatorActuatorPanel(),
                                                      angleErrorActuatorPanel()};
    return panels;
}

} // namespace halbench::app
