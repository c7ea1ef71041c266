#pragma once

#include "app/procedures/move/move_procedure.h"

namespace halbench::app {

/// Another axis that a path or table moves.
struct PartnerAxis {
    devices::AxisSpec axis;
    double window = 0.0; ///< as of MoveTask
};

/// The axis that moves, and how far and fast the board lets it: set for the move and watched by the host.
struct MoveTask {
    devices::AxisSpec axis;
    std::vector<PartnerAxis> partners = {}; ///< of a path or table
    double window = 0.0;                    ///< from where it is when armed, in the axis's unit
    double speedLimit = 0.0;

    bool moves(const devices::AxisSpec& other) const;
};

/// Position window of an axis that moves: twice its reference and its margin, within what the board takes.
double excursionWindow(const devices::Catalogue& catalogue, const MoveConfig& config,
                       const devices::AxisSpec& axis);

/// Errors: of the axis, its unit and the shape (move_procedure.h), OutOfRange, of the device.
Result<MoveTask> moveTask(devices::Device& device, const MoveConfig& config);

/// Waits for cool coils and a rotor at rest, or homes. True: it was homed now. Errors: Refused, OutOfRange (a
/// reference that leads beyond the end of an axis), of the device, of the abort.
Result<bool> prepareMove(devices::Device& device, const MoveConfig& config, const MoveTask& task,
                         const ProcedureObserver& observer);
Result<void> setMoveWindows(devices::Device& device, const MoveTask& task);
/// The reference of the axis, the path or the table, none for the others, and mode position.
Result<void> setMoveGenerator(devices::Device& device, const MoveConfig& config,
                              const devices::AxisSpec& axis, const ProcedureObserver& observer);

} // namespace halbench::app
