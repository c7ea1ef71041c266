#pragma once

#include "devices/formats/recording_file.h"

#include <QObject>

#include <functional>
#include <memory>

namespace halbench::app {

class DeviceSession;

/// All of the recording that the connected device plays; none of any other device. `then` is called on the
/// receiver's thread, not at once, and never after its end.
void askPlayedRecording(DeviceSession& session, QObject& receiver,
                        std::function<void(std::shared_ptr<const devices::RecordedFile>)> then);

} // namespace halbench::app
