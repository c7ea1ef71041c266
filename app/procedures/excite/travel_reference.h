#pragma once

#include "app/procedures/excite/move_reference.h"
#include "control/signals/plane_path.h"
#include "devices/device.h"

#include <array>
#include <optional>
#include <vector>

namespace halbench::app {

/// Trapezoid or S-curve: one axis, from rest to rest within limits (resources/help/planar-theory.md 9.1).
bool isTravel(const MoveReference& reference);
/// Circle, raster, arc or line: two axes.
bool isPath(const MoveReference& reference);

/// A figure that is missing or not positive. Errors: InvalidInput, OutOfRange.
Result<void> checkTravel(const MoveReference& reference);

/// Errors: as checkTravel().
Result<control::TravelProfile> travelProfile(const MoveReference& reference);
/// As a board with a loop period of 1 ms follows it. Errors: as checkTravel().
Result<control::PlanePath> planePath(const MoveReference& reference);

/// From the start of a travel or path to its end, known before it begins; nothing of other shapes.
std::optional<double> travelTime_s(const MoveReference& reference);
/// How long a move lasts where nothing is said: the travel and a second of rest; nothing of other shapes.
std::optional<double> defaultDuration_s(const MoveReference& reference);
/// The last part of a move in which the noise at rest is measured: half a second, of Rest all of it.
double restWindow_s(const MoveReference& reference, double duration_s);
/// Position of a travel at a time from its start; nothing where checkTravel() has an error.
std::optional<double> travelPointAt(const MoveReference& reference, double time_s);
/// Largest distance from the start along one of its axes.
double pathReach(const MoveReference& reference);
/// Values of the board's parameters for a path.
std::vector<ParameterValue> pathParameters(const MoveReference& reference);

/// The board's generator has this shape. Error: InvalidInput, the hint lists the shapes that it has.
Result<void> checkGenerator(const devices::Catalogue& catalogue, const devices::AxisSpec& axis,
                            const MoveReference& reference);
/// The two axes that a path moves: the first two along a line. Error: InvalidInput (a device without a path).
Result<std::array<devices::AxisSpec, 2>> pathAxes(const devices::Catalogue& catalogue);

} // namespace halbench::app
