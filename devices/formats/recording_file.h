#pragma once

#include "control/base/sample_block.h"
#include "devices/recording/recording_meta.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace halbench::devices {

/// A recording read back with what its sidecar (of an MDF4 file: the file itself) says; without a sidecar the
/// signals are named after the columns.
struct RecordedFile {
    Recording recording;
    RecordingMeta meta;
    bool hasMeta = false;
    std::vector<std::string> warnings; ///< e.g. the data were changed since
};
/// The known signals in their SI units (recording_units.h). Reads MDF4 when the name ends so, else CSV, of
/// which only the numbers are held: as many as a third of this machine's memory takes. `onProgress` hears
/// which share of a CSV file is read. Errors: FileSystem, InvalidInput with line and column or block and
/// octet, that of `checkAbort`.
Result<RecordedFile> readRecordingFile(const std::string& path,
                                       const std::function<Result<void>()>& checkAbort = {},
                                       const std::function<void(double)>& onProgress = {});

/// "dir/run.mf4"
bool isMdf4Recording(const std::string& path);

/// The text of a file that may be a recording or a table of another program. Errors: FileSystem, InvalidInput
/// (more than an eighth of this machine's memory, at least 256 MB).
Result<std::string> readTableText(const std::string& path);

/// What can be had of a recording that was interrupted.
struct PartialRecording {
    RecordedFile file;
    std::uint64_t cutOctets = 0;     ///< behind the last whole row: a piece of one, or what a power loss left
    std::uint64_t damagedOctets = 0; ///< left out: chunks whose checksum does not fit, and what is no row
    std::size_t uncheckedRows = 0;   ///< the last ones, which no checksum covers
};

/// "dir/run.csv.partial", the name of a recording that is not complete.
bool isPartialRecording(const std::string& path);

/// Reads `run.csv.partial` as an interrupted program left it (salvageRows()), with what its sidecar says; a
/// marker tells where it ends. Errors: FileSystem, InvalidInput (no row in it, or none that can be read; no
/// header: line and column).
Result<PartialRecording> readPartialRecording(const std::string& path);

/// Ends `run.csv.partial` when what can be had of it is safe elsewhere: removes it, its sidecar and its
/// checksums. Where octets inside it were damaged it is renamed instead, to `run.csv.damaged` or one beside
/// it: somebody may read more out of it. Answers that name, else nothing.
std::string retirePartialRecording(const std::string& path, bool isDamaged);

} // namespace halbench::devices
