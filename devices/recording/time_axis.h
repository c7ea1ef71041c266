#pragma once

#include "control/base/sample_block.h"

#include <cstdint>
#include <vector>

namespace halbench::devices {

/// Median distance of the first thousand rows; 0 with fewer than two rows.
double nominalPeriod(const std::vector<double>& time_s);

/// Rows missing in the time axis: those that would fill its gaps. Jitter of the stamps is no gap (RowGrid).
std::uint64_t countLostRows(const std::vector<double>& time_s, double period_s);

/// Sets the rates that the sidecar tells, and counts the missing rows by them. Entries that make no sense are
/// left out: a distance that is not positive, a time that does not increase.
void setRates(Recording& recording, const std::vector<RateChange>& rates);

/// Rows missing directly before this one.
std::uint64_t lostRowsBefore(const Recording& recording, std::size_t row);

} // namespace halbench::devices
