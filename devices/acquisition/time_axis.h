#pragma once

#include "control/base/sample_block.h"

#include <cstdint>
#include <vector>

namespace halbench::devices {

/// Median distance of the first thousand rows; 0 with fewer than two rows.
double nominalPeriod(const std::vector<double>& time_s);

/// Rows missing in the time axis: a step longer than 1.5 periods has lost the rows that would fill it.
std::uint64_t countLostRows(const std::vector<double>& time_s, double period_s);

/// Rows missing directly before this one.
std::uint64_t lostRowsBefore(const Recording& recording, std::size_t row);

} // namespace halbench::devices
