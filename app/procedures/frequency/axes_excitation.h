#pragma once

#include "app/procedures/frequency/axes_frequency_judge.h"

#include <string>

namespace halbench::app {

/// Parameter that sends the generator of an axis to the law (0) or adds it to the command of the law (1).
std::string effortTargetOf(const devices::AxisSpec& axis);

/// Records while all experiments of the plan run, band by band, each band after a pilot with little effort;
/// arms and disarms the device and fills recording, bands and experiments of `run`. Guarded from the host by
/// the board's own windows. The caller holds the RestoreGuard. Errors: SafetyStop, NotFinite, of the device,
/// of the abort.
Result<void> exciteAxes(devices::Device& device, const ProcedureObserver& observer, AxesFrequencyRun& run);

} // namespace halbench::app
