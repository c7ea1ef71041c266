#pragma once

#include "app/procedures/move/move_procedure.h"

#include <cstdint>

namespace halbench::app {

/// What speaks against a run. Doubtful: rows are missing, or the rotor ended far from where the reference
/// did. Refused: the reference that the board followed is not the one it was given (another start, another
/// program). `origin`: where the board's position stood when it began; a float there is that coarse.
DataQuality judgeMotion(const MoveResponse& response, const MoveConfig& config, std::uint64_t lostRows,
                        double origin, const devices::AxisSpec& axis = {});

/// The part of it that is about the reference, of a further axis of a table.
DataQuality judgeReference(const MoveResponse& response, const MoveConfig& config, std::uint64_t lostRows,
                           double origin, const devices::AxisSpec& axis);

} // namespace halbench::app
