#pragma once

#include "app/procedures/move/move_preparation.h"

#include <string>
#include <vector>

namespace halbench::app {

/// Of one update of the position loop to the next.
double loopPeriod_s(const devices::Catalogue& catalogue);

/// Of a device with one axis what a motor has; of one with several everything that plays a role.
std::vector<std::string> moveSignals(const devices::Catalogue& catalogue);

/// Cuts the recording to the time of the reference and measures the axis that moved, or both of a path, and
/// the others. Errors: Protocol (the reference did not start), of measureMove().
Result<MoveResult> judgeRecording(Recording recording, const MoveConfig& config, const MoveTask& task,
                                  const devices::Catalogue& catalogue);

} // namespace halbench::app
