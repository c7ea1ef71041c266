#pragma once

#include "control/base/parameter_spec.h"
#include "devices/device.h"

#include <vector>

namespace halbench::app {

/// What the board calls the mode.
inline double codeOf(devices::BoardMode mode) {
    return static_cast<double>(mode);
}

/// The mode goes with every motion: a number of one mode must not act in another. The board takes its own
/// mode as nothing new.
inline std::vector<ParameterValue> inMode(devices::BoardMode mode, std::vector<ParameterValue> motion) {
    motion.insert(motion.begin(), {"hb.mode", codeOf(mode)});
    return motion;
}

} // namespace halbench::app
