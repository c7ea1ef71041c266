#pragma once

#include "devices/simulated/simulated_model.h"

namespace halbench::devices {

/// The stage of stage_board.h. Overrides: `ma`, `mb` (moving masses in kg), `friction` of axis b in N.
SimulatedModel stageModel();

} // namespace halbench::devices
