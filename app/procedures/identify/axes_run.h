#pragma once

#include "app/procedures/identify/axes_identification.h"

#include <string>
#include <string_view>
#include <vector>

namespace halbench::app {

/// Identification of several axes on a device, as one kind of actuator does it.
struct AxesRun {
    /// Before anything is written. Errors: of the configuration.
    Result<void> (*check)(const devices::Catalogue& catalogue, const IdentifyConfig& config);
    /// Parameters that the measurement sets, beside those that every procedure restores.
    std::vector<std::string> (*restored)(const devices::Catalogue& catalogue);
    /// Moves the axes and fits. The caller restores.
    Result<AxesIdentifyResult> (*measure)(devices::Device& device, const IdentifyConfig& config,
                                          const ProcedureObserver& observer,
                                          const std::vector<devices::AxisSpec>& axes,
                                          const MeasuredTiming& timing);
};

/// Walks Prepare, the stages of `measure`, then Done or Restored; parameters are restored on every way out.
/// Errors: Usage (the device does not offer it), of `check`, of `measure`, of the device.
Result<IdentifyOutcome> runAxes(const AxesRun& run, devices::Device& device, const IdentifyConfig& config,
                                const ProcedureObserver& observer);

/// Axes that exist and no options that only a motor has. Errors: UnknownName, Usage with the hint
/// that says which options this device takes.
Result<void> checkAxesOptions(const devices::Catalogue& catalogue, const IdentifyConfig& config,
                              const std::string& hint);

/// A mass or an inertia as a user gives it. Errors: NotFinite, OutOfRange.
Result<void> checkGivenInertia(std::string_view symbol, double value);

} // namespace halbench::app
