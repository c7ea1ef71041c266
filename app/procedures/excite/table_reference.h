#pragma once

#include "app/procedures/excite/move_reference.h"
#include "app/procedures/excite/pose_table.h"
#include "app/procedures/excite/travel_ends.h"
#include "devices/device.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace halbench::app {

/// A table of poses and the motion through them (resources/help/command-line.md, "Paths from a table").
struct TabledMotion {
    PoseTable table;
    control::PoseMotion motion; ///< an axis a column of the table
};

bool isTable(const MoveReference& reference);
/// A table or one of the paths of two axes: the axes that it moves are its own.
bool movesSeveralAxes(const MoveReference& reference);

/// The keys of a table, before its file is read. Errors: InvalidInput.
Result<void> checkTableKeys(const MoveReference& reference);

/// The reference follows this table from now on; its travel time is then known. Without times it needs the
/// largest speed and acceleration of every quantity that the table has; with times these are limits that it
/// has to keep. Errors: InvalidInput, OutOfRange with file, line, row, value and limit.
Result<void> attachTable(MoveReference& reference, PoseTable table);

/// The axes of a device that the table moves, in the order of the device. Errors: InvalidInput (an axis that
/// the device does not have or in another quantity, a device that follows no table, a table with more pieces
/// than fit).
Result<std::vector<devices::AxisSpec>> tableAxes(const devices::Catalogue& catalogue,
                                                 const MoveReference& reference);

/// Limits of one axis of a device; the names are those of its parameters.
struct TableAxisLimits {
    std::string axis;
    double window = 0.0; ///< to either side
    std::string windowName;
    double speed = 0.0;
    std::string speedName;
    std::optional<double> acceleration = {}; ///< where the board's force and the inertia are known
    double from = 0.0;                       ///< where the motion begins, counted from the window's middle
};
/// Every row and the way between. Errors: OutOfRange with file, line, row, value and limit.
Result<void> checkTableLimits(const MoveReference& reference, const std::vector<TableAxisLimits>& limits);

/// Every row and the way between. Errors: OutOfRange with file, line, row, and how far it may go.
Result<void> checkTableEnds(const MoveReference& reference, const std::vector<AxisTravel>& ends);

/// Position of an axis at a time from the start; nothing of an axis that the table does not move.
std::optional<double> tablePointAt(const MoveReference& reference, double time_s, std::string_view axis);
/// Largest distance of an axis from its start; of an empty name that of all, 0 of one that does not move.
double tableReach(const MoveReference& reference, std::string_view axis);

/// Writes the pieces of the motion into the board, where they wait for the start. `keepGoing` is asked
/// before every piece. Errors: of the device, of `keepGoing`.
Result<void> writeTable(devices::Device& device, const MoveReference& reference,
                        const std::function<Result<void>()>& keepGoing);
/// Values of the board's parameters that make it follow what was written.
std::vector<ParameterValue> tableParameters(const MoveReference& reference);

} // namespace halbench::app
