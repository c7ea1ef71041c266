#pragma once

#include "devices/simulated/simulated_model.h"

namespace halbench::devices {

/// `sim:toy?m=0.2`: the slides of toy_board.h, each of mass m in kg on a damping of 1 N s/m; 0.3 N of
/// friction on y. Its scales are good to 0.1 um, by the seed.
SimulatedModel toyModel();

/// `sim:sense`: the same slides, moved by nothing, on a board that only senses: no order to arm and no axis.
SimulatedModel sensingToyModel();

} // namespace halbench::devices
