#pragma once

#include "devices/device.h"

#include <QString>

namespace halbench::app {

/// Why the board does not drive, and what to do about it before it is armed again.
struct FaultWords {
    QString what;
    QString remedy;
};

/// Words for a latched stop or fault; both empty when there is none. An unknown code keeps the board's words.
FaultWords faultWords(const devices::DeviceState& board);

/// Why a stop is latched, to be said behind "Stopped"; empty when the board gives no reason.
QString stopReason(const devices::DeviceState& board);

} // namespace halbench::app
