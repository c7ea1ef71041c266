#pragma once

#include "devices/formats/recording_file.h"

#include <functional>
#include <string>
#include <string_view>

namespace halbench::devices {

/// Reads an MDF 4.10 file that Mdf4Writer wrote: names, units, roles, parameters, markers and changes come
/// back, a value that is no finite number reads as NaN. Needs memory of the file's own size. Errors:
/// InvalidInput with block and offset (other programs' files, unfinalised, cut off, damaged); that of
/// `checkAbort`, which is asked every thousand rows.
Result<RecordedFile> parseMdf4(std::string_view octets, const std::string& origin,
                               const std::function<Result<void>()>& checkAbort = {});

} // namespace halbench::devices
