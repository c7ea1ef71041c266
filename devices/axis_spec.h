#pragma once

#include "control/base/units.h"

#include <string>

namespace halbench::devices {

/// Roles of the signals and windows of one axis. On a device with one axis the bare role is that axis.
struct AxisRoles {
    std::string position = "position";
    std::string speed = "speed";
    std::string reference = "reference";
    std::string effort = "current_command";
    std::string command; ///< of law and excitation, before limit and delay; few boards tell it
    std::string truePosition = "truth.position"; ///< of a simulated device
    std::string positionWindow = "window.position";
    std::string speedWindow = "window.speed";
};

/// What one feedback loop of a device controls. Positions are in `positionUnit`, speeds in that per second.
/// The defaults are the axis of a board without a profile: it turns, its effort is a current.
struct AxisSpec {
    std::string id = "angle";
    std::string title = "Angle";
    std::string positionUnit = "rad"; ///< "rad" or "m"
    std::string effortUnit = "A";
    AxisRoles roles = {};
    std::string generator = "reference";     ///< its parameters begin so: "reference.shape"
    bool turnsForever = true;                ///< else the board's position window is all its travel
    double windowMargin = 0.5 * Pi;          ///< of a position window, beyond twice the reference
    double settle_s = 0.05;                  ///< from arming to rest
    double referenceTolerance = 1e-4;        ///< resolution of the board's reference
    double endTolerance = 20.0 * Pi / 180.0; ///< a rest this far from the reference needs no finding
    double designFrequency_rad_s = 0.0; ///< of a recommended loop; 0: as fast as its delays allow at ease
    double testStep = 0.0;              ///< that proves a loop; 0: half a radian
    double effortLimit = 0.0; ///< available everywhere at the board's largest current "I_max"; 0: not known
};

} // namespace halbench::devices
