#pragma once

#include "control/base/sample_block.h"
#include "devices/recording/recording_meta.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace halbench::devices {

/// What can be had of the text of a recording that was interrupted.
struct SalvagedRows {
    Recording recording;             ///< signals named after the columns; it may be without rows
    std::uint64_t cutOctets = 0;     ///< behind the last whole line: a piece of one, or zeros of a power loss
    std::uint64_t damagedOctets = 0; ///< left out: what no checksum fits, and from a line on that is no row
    std::size_t uncheckedRows = 0;   ///< the last ones, which came after the last checksum
};

/// Reads `text`, of which `journal` (recording_chunks.h) says what was written. A chunk whose checksum does
/// not fit is left out, and only that one. What has no checksum, or a chunk of which the file has only the
/// beginning, is read up to the first line that is no row of ours; where its time goes back, the row before
/// may be the wrong one and is left out as well. The columns are those of the first line; where no checksum
/// confirms it, those that the sidecar names. Errors: InvalidInput (neither says the columns).
Result<SalvagedRows> salvageRows(std::string_view text, std::string_view journal, const RecordingMeta& meta,
                                 const std::string& origin);

/// Whether there is more than a header and the piece of a row: otherwise nothing was recorded.
bool holdsRows(std::string_view text, const RecordingMeta& meta);

} // namespace halbench::devices
