#pragma once

#include "app/recordings/run_comparison.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace halbench::app {

/// What `halbench overlay` was asked for; times since the moment.
struct OverlayRequest {
    RunAlignment alignment;
    std::optional<double> from_s; ///< absent: where the first run begins
    std::optional<double> to_s;   ///< absent: where the last run ends; included
};

/// "start", "trigger", or the text of a marker behind "marker:". Errors: Usage.
Result<RunAlignment> alignmentNamed(const std::string& text);

/// The names of the runs as parts of signal names: what is no letter, digit, '-' or '_' becomes '_', a name
/// that is there twice gets a number.
std::vector<std::string> runLabels(const std::vector<ComparedRun>& runs);

/// All runs on one time axis: rows at whole multiples of the shortest period of them, zero at the moment. The
/// signals, which must be the same in all runs, are called LABEL.SIGNAL, run after run. Between two samples a
/// value lies on the line through them; a state or count (no unit) is that of the nearest sample. A sample
/// that lies on the axis keeps its value to the last bit. NaN in a gap, before and behind a run. Errors:
/// InvalidInput (a run without the moment), OutOfRange (no row, or more than MostComparedValues numbers).
Result<Recording> onOneAxis(const std::vector<ComparedRun>& runs, const OverlayRequest& request);

/// How far two columns of a recording are apart, column - reference, where both have values.
struct ColumnDifference {
    std::size_t rows = 0; ///< with both values; the others are zero when there is none
    double mean = 0.0;
    double rms = 0.0;
    double largest = 0.0; ///< by amount, with its sign
    double largestAt_s = 0.0;
};
ColumnDifference differenceBetween(const Recording& recording, std::size_t reference, std::size_t column);

} // namespace halbench::app
