#pragma once

#include "app/procedures/analyse.h"
#include "devices/device.h"

namespace halbench::app {

/// The surroundings of the loop from the shipped profile of a model (period, current limit, stray field);
/// defaults for a model without one. Errors: of the profile.
Result<LoopConditions> loopConditionsOf(const std::string& model);

/// The same from what an open device says of itself: its delay, its current limit, its stray-field
/// compensation. Errors: of the device.
Result<LoopConditions> loopConditionsOf(devices::Device& device);

} // namespace halbench::app
