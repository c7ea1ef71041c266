#pragma once

#include "app/procedures/base/procedure.h"
#include "devices/device.h"

#include <string>

namespace halbench::app {

/// Why rows are missing, as far as the link counted it between two moments, and what helps against that.
struct RowLossCause {
    std::string words; ///< "the line damaged 2 % of the frames"; empty: the link counts nothing
    std::string remedy;
};
RowLossCause causeOfRowLoss(const devices::LinkStatistics& before, const devices::LinkStatistics& after);

/// An error because of rows that were lost, with their cause and what helps against that first.
Error withCause(Error error, const RowLossCause& cause);
/// Names the cause in the findings of rows that were lost ("rows_lost").
void nameRowLoss(DataQuality& quality, const RowLossCause& cause);

} // namespace halbench::app
