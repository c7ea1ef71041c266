#pragma once

#include "control/base/result.h"
#include "control/base/sample_block.h"

#include <optional>
#include <string>
#include <vector>

namespace halbench::devices {

/// What `halbench convert` was asked for.
struct ConvertRequest {
    std::string input;
    std::string output;
    std::vector<std::string> signals; ///< names or columns; empty = all
    std::optional<double> from_s;     ///< first time kept
    std::optional<double> to_s;       ///< first time not kept
};

/// Rows of [from, to) and the signals asked for, in their order; the time axis stays as recorded.
/// Errors: UnknownName (signal), OutOfRange (no rows in the interval), NotFinite.
Result<Recording> selectPart(const Recording& recording, const std::vector<std::string>& signals,
                             std::optional<double> from_s, std::optional<double> to_s);

/// Reads, selects, writes; gives the number of rows. Formats go by the file's ending; this version knows
/// .csv. Errors: Usage (format), FileSystem, InvalidInput, those above.
Result<std::size_t> convertRecording(const ConvertRequest& request);

} // namespace halbench::devices
