#pragma once

#include "app/procedures/move/move_procedure.h"
#include "app/procedures/tune/analyse.h"

#include <optional>

namespace halbench::app {

/// Figures of a move of one axis as its model foresees them: the law that the device has now, the friction of
/// the model, the effort limit. Nothing for a reference without an ideal form (chirp, multisine). Errors: of
/// the model, of the device, of chosenAxis.
Result<std::optional<MoveFigures>> predictAxisMove(devices::Device& device, const MoveConfig& config,
                                                   const MotorEstimate& estimate, double effortLimit);

} // namespace halbench::app
