#pragma once

#include "devices/simulated/simulated_model.h"

namespace halbench::devices {

/// `sim:toy?m=0.2`: the slide of toy_board.h, of mass m in kg, on a damping of 1 N s/m. The seed is not used.
SimulatedModel toyModel();

} // namespace halbench::devices
