#pragma once

#include "app/session/device_session.h"
#include "control/base/result.h"
#include "widgets/controls/message_bar.h"

#include <optional>

namespace halbench::app {

/// Why a procedure ended with its device: it was disconnected by the user, or the connection was lost; what
/// became of the board in either case. Nothing for one that ended otherwise. To be asked when it ends.
std::optional<widgets::Message> departureMessage(const DeviceSession& session, const Error& error);

} // namespace halbench::app
