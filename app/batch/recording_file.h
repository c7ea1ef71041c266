#pragma once

#include "control/base/sample_block.h"
#include "devices/device.h"

#include <string>
#include <string_view>

namespace halbench::app {

/// Writes a recording as CSV with its sidecar NAME.meta.json (resources/help/command-line.md, "Recording");
/// `started` is the header's, so that virtual time gives equal bytes. Error: FileSystem.
Result<void> writeRecording(const std::string& path, const Recording& recording, devices::Device& device,
                            const std::string& started);

} // namespace halbench::app
