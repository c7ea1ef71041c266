#pragma once

#include "app/workbench/drive_ability.h"
#include "app/workbench/workbench.h"

#include <QWidget>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace halbench::app {

/// A panel of the window that belongs to one kind of actuator. It names what it needs of a device, never the
/// device, and is offered with every device that has it.
struct ActuatorPanel {
    std::string id;                      ///< stable, in layout files
    const char* title;                   ///< of the translation context "Panels"
    const char* helpAddress;             ///< page and section of resources/help
    std::vector<std::string> parameters; ///< roles of the parameters that it needs
    std::function<QWidget*(Workbench&)> make;
};

/// Whether a device has all parameters that the panel needs.
inline bool isMadeFor(const ActuatorPanel& panel, const devices::Catalogue& catalogue) {
    return std::all_of(panel.parameters.begin(), panel.parameters.end(), [&](const std::string& role) {
        return catalogue.findParameter(parameterOfRole(catalogue, role)) != nullptr;
    });
}

} // namespace halbench::app
