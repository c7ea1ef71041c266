#pragma once

#include "app/procedures/excite/move_reference.h"

#include <span>
#include <string>
#include <string_view>

namespace halbench::app {

/// One key of a reference as written on the command line or in an experiment.
struct MoveReferenceKey {
    std::string_view key;  ///< e.g. "amplitude_deg"
    std::string_view help; ///< one sentence
};
std::span<const MoveReferenceKey> moveReferenceKeys();
/// Separated by commas.
std::string moveReferenceKeyNames();

/// Sets one key: amplitude, rate and base with their unit (amplitude_deg, rate_um_s ...), frequency_hz,
/// frequency_end_hz, period_s (of a sine: 1/frequency; of a staircase: time of one step), count, seed; of
/// travels and paths acceleration, jerk, radius, width, pitch with their unit, turns, lines. Set the shape
/// first. Errors: UnknownName (hint lists the keys), NotFinite, OutOfRange, InvalidInput (a length beside an
/// angle).
Result<void> setMoveReference(MoveReference& reference, std::string_view key, double value);

} // namespace halbench::app
