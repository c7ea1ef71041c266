#pragma once

#include "app/workbench/drive_ability.h"
#include "app/workbench/file_chooser.h"
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
    std::function<void(QWidget&, FileChooser)> setFileChooser = {}; ///< of its own panel, when it has files
    std::vector<std::string> signalRoles = {};                      ///< of the signals that it needs
};

/// Whether a device has all parameters and signals that the panel needs.
inline bool isMadeFor(const ActuatorPanel& panel, const devices::Catalogue& catalogue) {
    const bool hasSignals =
        std::all_of(panel.signalRoles.begin(), panel.signalRoles.end(), [&](const std::string& role) {
            return catalogue.findSignal(signalOfRole(catalogue, role)) != nullptr;
        });
    return hasSignals &&
           std::all_of(panel.parameters.begin(), panel.parameters.end(), [&](const std::string& role) {
               return catalogue.findParameter(parameterOfRole(catalogue, role)) != nullptr;
           });
}

} // namespace halbench::app
