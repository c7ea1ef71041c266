#pragma once

#include "devices/simulated/simulated_model.h"

#include <deque>
#include <string>

namespace halbench::devices {

/// Every simulated device of the program, one row per actuator, in the order of lists.
const std::deque<SimulatedModel>& simulatedModels();

/// Adds a row, for tests: before the first device is opened, since the table is not guarded. A row of the
/// same name is replaced.
void addSimulatedModel(SimulatedModel model);

/// nullptr if there is none.
const SimulatedModel* findSimulatedModel(const std::string& name);

} // namespace halbench::devices
