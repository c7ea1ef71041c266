#pragma once

#include "devices/xcp/board_description.h"
#include "devices/xcp/xcp_master.h"

namespace halbench::devices::xcp {

/// Reads the board's own capture (up to 4 signals x 4096 samples at loop rate) as a recording whose time is
/// measured from the trigger, negative before it. Empty while it is not full.
/// The board names the signals by their measurement number in `capture.signal_1` ... (3.16).
/// Errors: DeviceRefused (a board without capture), those of the link.
Result<Recording> readBoardCapture(Device& device, const BoardDescription& board, XcpMaster& master);

} // namespace halbench::devices::xcp
