#pragma once

#include "control/history/sample_history.h"

#include <string>
#include <vector>

namespace halbench::app {

/// The last `length_s` of the history as a recording: the rows in which all of these signals have a value, at
/// most `mostRows`. Columns are in this order, with the units of the history; no rows where a signal is
/// unknown or the signals were not streamed together.
Recording lastRows(const control::SampleHistory& history, const std::vector<std::string>& signals,
                   double length_s, std::size_t mostRows);

} // namespace halbench::app
