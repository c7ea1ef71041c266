#pragma once

#include "app/procedures/procedure.h"

#include <string>
#include <vector>

namespace halbench::app {

struct RecordConfig {
    std::vector<std::string> signals; ///< names; empty: the profile's default signals
    double rate_Hz = 100.0;           ///< must divide the event rate of every signal
    double duration_s = 1.0;
};

struct RecordResult {
    Recording recording; ///< rows at t = 0, 1/R, ... < duration
    DataQuality quality; ///< doubtful when rows were lost
};

/// Listens; never arms, never writes. Walks Prepare, Record, Done.
/// Errors: UnknownName (signal), OutOfRange (rate: the hint names the nearest allowed ones; duration), of the
/// device, of the abort.
Result<RecordResult> runRecord(devices::Device& device, const RecordConfig& config,
                               const ProcedureObserver& observer);

} // namespace halbench::app
