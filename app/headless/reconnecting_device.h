#pragma once

#include "app/headless/command_context.h"
#include "app/headless/recording_file.h"
#include "devices/open/returning_device.h"

#include <memory>
#include <string>

namespace halbench::app {

/// A device that a recording waits for when it is lost: looked for by its serial number where it has one.
std::unique_ptr<devices::ReturningDevice> reconnectingDevice(CommandContext& context, const std::string& uri,
                                                             std::unique_ptr<devices::Device> device);

/// Loss and return as markers of the recording and as warnings. The output must outlive the events.
devices::ReturningDevice::Events eventsTo(WarningSink warn, RecordingOutput& output);

} // namespace halbench::app
