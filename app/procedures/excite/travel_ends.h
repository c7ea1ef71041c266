#pragma once

#include "app/procedures/excite/move_reference.h"
#include "control/signals/plane_path.h"

#include <optional>
#include <string>

namespace halbench::app {

/// Where an axis with ends stands, counted from the middle of its travel.
struct AxisTravel {
    std::string axis;
    double travel = 0.0; ///< to either side, in the axis's unit
    double position = 0.0;
};

/// How far the reference moves an axis to either side of where it is when armed. Of chirp, sine and multisine
/// the largest that their amplitudes allow. `pathAxis`: of a path 0 or 1, its first or second axis.
/// Not of a table, whose rows checkTableEnds() names.
control::PathSpan referenceSpan(const MoveReference& reference, double duration_s, std::size_t pathAxis = 0);

/// The farthest place of a motion that leads beyond an end of the travel; nothing of one that stays within or
/// only leads inwards, so that an axis at its stop can be moved away.
std::optional<double> placeBeyondEnd(const AxisTravel& axis, const control::PathSpan& span);

/// Error: OutOfRange, with the place and the end.
Result<void> checkReferenceEnds(const AxisTravel& axis, const std::string& unit,
                                const control::PathSpan& span);

} // namespace halbench::app
