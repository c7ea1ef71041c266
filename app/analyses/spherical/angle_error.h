#pragma once

#include "control/base/sample_block.h"

#include <string>
#include <vector>

namespace halbench::app {

/// Signals, by role, that the angle between an estimate and the truth needs: the quaternion of the board, the
/// true angles of a simulation, and the cone that the board gives.
std::vector<std::string> angleErrorRoles();

/// Angle between the orientation that a board estimates and the true one, modulo the symmetry of the rotor.
struct AngleErrors {
    std::vector<double> time_s; ///< of the points that are drawn
    std::vector<double> rotation_rad;
    std::vector<double> shaft_rad;
    std::vector<double> cone_rad; ///< 95 % cone of the shaft
    std::size_t rows = 0;
    double rms_rad = 0.0; ///< of the rotation, over all rows
    double worst_rad = 0.0;
};

/// From rows with the columns of angleErrorRoles(), in its order. Of more than `mostPoints` rows the one with
/// the largest error of each part is a point. Source: resources/help/spherical-theory.md section 7.
AngleErrors angleErrors(const Recording& rows, std::size_t mostPoints);

} // namespace halbench::app
