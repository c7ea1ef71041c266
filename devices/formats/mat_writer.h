#pragma once

#include "control/base/result.h"
#include "control/base/sample_block.h"
#include "devices/recording/recording_meta.h"

#include <string>
#include <vector>

namespace halbench::devices {

/// What the columns are called in MATLAB and Octave, in their order: letters, digits and '_', a letter first,
/// at most 63 characters, no word of the language, none of our own variables; a name that is taken gets "_2",
/// "_3" ... "hall.a" -> "hall_a".
std::vector<std::string> matNames(const StreamLayout& layout);

/// Writes a recording as a MAT file (version 5, uncompressed): column vectors `time_s` and one per signal,
/// the struct `units` with a field for each of them, texts `meta_model`, `meta_id`, `meta_firmware`,
/// `meta_started`, `meta_software` and `meta_json`, the sidecar (its SHA-256 is that of no file and empty).
/// Equal recordings give equal files. On an error nothing is left behind and an older file stays. Errors:
/// FileSystem.
Result<void> writeMatFile(const std::string& path, const Recording& recording, RecordingMeta meta);

} // namespace halbench::devices
