#pragma once

#include "control/base/block_columns.h"
#include "devices/device.h"

namespace halbench::app {

/// Shows gaps instead of the reference of a board that is not armed, or whose mode uses none yet: it sends
/// exactly zero for it, beside which an angle of many turns would be flattened. All of it where it is no
/// angle. Nothing changes for a block that says nothing of the board's state.
void hideReferenceMask(BlockColumns& columns, const SampleBlock& block, const devices::Catalogue& catalogue,
                       bool isAngle);

} // namespace halbench::app
