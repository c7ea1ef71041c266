#pragma once

#include "app/procedures/move/move_procedure.h"

namespace halbench::app {

/// The axis that moves, and how far and fast the board lets it: set for the move and watched by the host.
struct MoveTask {
    devices::AxisSpec axis;
    std::optional<devices::AxisSpec> second = {}; ///< of a path
    double window = 0.0;                          ///< from where it is when armed, in the axis's unit
    double speedLimit = 0.0;
};

/// Position window of a move: twice the reference and the margin of the axis, within what the board takes.
double excursionWindow(const devices::Catalogue& catalogue, const MoveConfig& config,
                       const devices::AxisSpec& axis);

/// Errors: of the axis, its unit and the shape (move_procedure.h), OutOfRange, of the device.
Result<MoveTask> moveTask(devices::Device& device, const MoveConfig& config);

/// Homes a board that does not know its zero; nothing moves. Errors: Refused, of the device, of the abort.
Result<void> awaitZero(devices::Device& device, const ProcedureObserver& observer);

/// Waits for cool coils and a rotor at rest, or homes. Errors: Refused, of the device, of the abort.
Result<void> prepareMove(devices::Device& device, const MoveConfig& config, const devices::AxisSpec& axis,
                         const ProcedureObserver& observer);
Result<void> setMoveWindows(devices::Device& device, const MoveTask& task);
/// The reference of the axis or the path, none for the others, and mode position.
Result<void> setMoveGenerator(devices::Device& device, const MoveConfig& config,
                              const devices::AxisSpec& axis);

} // namespace halbench::app
