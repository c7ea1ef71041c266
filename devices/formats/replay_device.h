#pragma once

#include "devices/device.h"
#include "devices/formats/recording_file.h"

#include <functional>
#include <memory>
#include <string>

namespace halbench::devices {

/// A recording as a Device (`replay:FILE`): its signals stream again on a virtual clock that begins at the
/// first row; its parameters have the values of the recording's start. It cannot be changed and never arms.
/// Waiting beyond the last row is a DeviceLost. `FILE?at=S`, where no file is called so, begins S seconds
/// after the first row: the clock and the rows have the same times as without it. Errors: those of reading
/// the file; OutOfRange (a time behind its end); that of `checkAbort`, which is asked while it is read, as
/// `onProgress` is told.
Result<std::unique_ptr<Device>> openReplayDevice(const std::string& uri, const std::string& path,
                                                 const std::function<Result<void>()>& checkAbort = {},
                                                 const std::function<void(double)>& onProgress = {});

/// All of the recording that such a device plays; it never changes. Any other device: none.
std::shared_ptr<const RecordedFile> recordingOf(const Device& device);

} // namespace halbench::devices
