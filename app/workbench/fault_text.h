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
/// `asker` as stopReason takes it.
FaultWords faultWords(const devices::DeviceState& board, const QString& asker = {});

/// Why a stop is latched, to be said behind "Stopped"; empty when the board gives no reason. A board knows
/// only that it was told to: who told it, as "by Esc", is said where it is known.
QString stopReason(const devices::DeviceState& board, const QString& asker = {});

} // namespace halbench::app
