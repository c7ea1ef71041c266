#pragma once

#include "app/procedures/base/procedure.h"
#include "app/procedures/record/triggered_rows.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace halbench::app {

struct RecordConfig {
    std::vector<std::string> signals; ///< names; empty: the profile's default signals
    double rate_Hz = 100.0;           ///< must divide the event rate of every signal
    double duration_s = 1.0;          ///< with a trigger: from that on
    /// Its signal is recorded too. Without: begins at once.
    std::optional<RecordTrigger> trigger;
};

struct RecordResult {
    Recording recording; ///< rows at t = 0, 1/R, ... < duration; none with an outlet
    std::size_t rows = 0;
    std::uint64_t lostRows = 0;
    std::uint64_t gaps = 0;          ///< stretches without rows
    double gaps_s = 0.0;             ///< how long they are together
    std::optional<double> trigger_s; ///< in the recording's time
    DataQuality quality;             ///< doubtful when rows were lost
};

/// Where rows go as they come, e.g. a file, instead of into memory.
struct RecordOutlet {
    /// Once, before the device is asked to send; signals with units and the period. May call the device.
    std::function<Result<void>(const StreamLayout&)> begin;
    std::function<Result<void>(const SampleBlock&)> append; ///< must not call the device
};

/// Listens; never arms, never writes. Walks Prepare, Record, Done.
/// Errors: UnknownName (signal), OutOfRange (rate: the hint names the nearest allowed ones; duration),
/// Refused (no event within the trigger's patience), of TriggeredRows, of the device, of the abort, of the
/// outlet.
Result<RecordResult> runRecord(devices::Device& device, const RecordConfig& config,
                               const ProcedureObserver& observer, const RecordOutlet* outlet = nullptr);

} // namespace halbench::app
