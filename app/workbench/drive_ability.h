#pragma once

#include "devices/device.h"

#include <string>

namespace halbench::app {

/// The board is armed by the protocol's parameter (resources/help/protocol.md 3.15).
inline bool canBeArmed(const devices::Catalogue& catalogue) {
    return catalogue.findParameter("hb.arm") != nullptr;
}

/// And its profile names its axes with their units. A board that only senses, and one without a profile, is
/// not driven from the window.
inline bool canBeDriven(const devices::Catalogue& catalogue) {
    return canBeArmed(catalogue) && !catalogue.axes.empty();
}

/// Name of the signal that plays the role on this device; the role itself where none does, which is what a
/// board without a profile would call it.
inline std::string signalOfRole(const devices::Catalogue& catalogue, const std::string& role) {
    const std::string name = catalogue.signalForRole(role);
    return name.empty() ? role : name;
}

/// The same for a parameter.
inline std::string parameterOfRole(const devices::Catalogue& catalogue, const std::string& role) {
    const std::string name = catalogue.parameterForRole(role);
    return name.empty() ? role : name;
}

} // namespace halbench::app
