#pragma once

#include "app/actuators/spherical/sensing_board.h"
#include "app/actuators/spherical/sensing_motion.h"

#include <optional>

namespace halbench::app {

/// Readings of the wrong sign, or known orientations that are not those of the readings; nothing when they
/// agree. A channel, a sensor or a component is reversed when that, and nothing else, makes the nine readings
/// those of one field. All nine reversed are the field of a rotor spun by 90 degrees: only orientations in
/// the recording tell them.
std::optional<Finding> contradictingReadings(const SensedMotion& motion, const SensingBoard& board);

} // namespace halbench::app
