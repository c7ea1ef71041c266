#pragma once

#include "control/base/sample_block.h"
#include "devices/device.h"

namespace halbench::app {

/// The block for showing: while the board is not armed there is no reference, although the board sends zero
/// for it; those samples become gaps. A block that says nothing of the board's state stays as it is.
SampleBlock withoutIdleReference(const SampleBlock& block, const devices::Catalogue& catalogue);

} // namespace halbench::app
