#pragma once

#include "control/base/result.h"
#include "control/base/sample_block.h"

#include <cstddef>
#include <string>
#include <vector>

namespace halbench::app {

/// A value in every row of a signal from row `first` on. Error: NotFinite with signal, row, time, and the
/// line of a CSV file.
Result<void> checkRecordedValues(const Recording& recording, const std::string& signal,
                                 const std::vector<double>& values, std::size_t first = 0);

} // namespace halbench::app
