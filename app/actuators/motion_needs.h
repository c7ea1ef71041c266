#pragma once

#include "control/base/sample_block.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace halbench::app {

/// A direction of the shaft, and how much data with it would add: 0 nothing, 1 the most of all.
struct ShaftNeed {
    double theta_rad = 0.0; ///< from Z
    double phi_rad = 0.0;   ///< from X
    double share = 0.0;
};

/// How well a motion that somebody makes by hand determines a calibration so far.
struct MotionNeeds {
    bool isEnough = false;
    std::vector<ShaftNeed> shafts;
    std::vector<std::string> missing; ///< "alpha 40, beta -40, gamma 0 deg", most wanted first
    std::string order;                ///< of the rotations by these angles; empty while none is missing
};

/// From the rows that the calibration's stream gave so far and the values on the board, by name.
using MotionNeedsFunction = MotionNeeds (*)(const Recording& rows,
                                            const std::map<std::string, double>& values);

/// Function of a device model whose calibration records a motion made by hand; nullptr where the device moves
/// itself.
MotionNeedsFunction motionNeedsOf(std::string_view model);

} // namespace halbench::app
