#pragma once

#include "devices/device.h"

#include <memory>
#include <string>

namespace halbench::devices {

/// A recording as a Device (`replay:FILE`): its signals stream again on a virtual clock that begins at the
/// first row; its parameters have the values of the recording's start. It cannot be changed and never arms.
/// Waiting beyond the last row is a DeviceLost. Errors: those of reading the file.
Result<std::unique_ptr<Device>> openReplayDevice(const std::string& uri, const std::string& path);

} // namespace halbench::devices
