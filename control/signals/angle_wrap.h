#pragma once

#include <optional>
#include <vector>

namespace halbench::control {

/// Puts an angle together again that was recorded within a turn, or a few, and jumps at its end: a difference
/// of rows of more than half the range, where the range is a whole number of turns. Answers the turn in
/// radians; nothing, and the angle as it was, for one that does not wrap.
std::optional<double> unwrapAngle(std::vector<double>& angle_rad);

} // namespace halbench::control
