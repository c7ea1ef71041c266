#pragma once

#include "control/base/sample_block.h"
#include "devices/device.h"

namespace halbench::app {

/// The block for showing: while the board is not armed, and until its mode uses one, there is no reference,
/// although the board sends exactly zero for it; an angle of many turns beside that would be flattened. Those
/// samples become gaps, and all where it is no angle. A block that says nothing of the board's state stays as
/// it is.
SampleBlock withoutIdleReference(const SampleBlock& block, const devices::Catalogue& catalogue, bool isAngle);

} // namespace halbench::app
