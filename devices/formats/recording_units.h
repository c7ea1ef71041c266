#pragma once

#include "devices/formats/recording_file.h"

#include <string>
#include <vector>

namespace halbench::devices {

/// Converts the known signals of a file that was read, "position_deg" or "speed_rpm", to their SI units, in
/// the data and in what is told of them. `isNoted`: of which columns the sidecar says name and unit; there a
/// unit of another quantity stays as it is, for boards measure what they like. Without a unit SI is assumed,
/// with a warning. Errors: InvalidInput naming the column of `origin` (a unit that is not known, of another
/// quantity, or that contradicts the sidecar).
Result<void> convertToSi(RecordedFile& file, const std::vector<bool>& isNoted, const std::string& origin);

/// What a warning of the reader is about.
bool isUnitWarning(const std::string& warning);

} // namespace halbench::devices
