#pragma once

#include "app/procedures/calibrate_procedure.h"
#include "app/procedures/procedure_steps.h"

#include <vector>

namespace halbench::app {

/// Each adds its figures, proposed values and findings to the result and leaves the motor disarmed. The
/// caller holds the RestoreGuard. Errors: of the device, of the abort; data that do not support a figure
/// become a finding.

/// Field of the phase currents at their own sensors, at standstill with pure d-axis current at three angles.
Result<void> calibrateStray(devices::Device& device, const CalibrateConfig& config,
                            const ProcedureObserver& observer, CalibrateResult& result);

/// Ellipse of the two Hall readings in slow motion both ways; the stray field is taken out with the value
/// found before, or the board's.
Result<void> calibrateHall(devices::Device& device, const CalibrateConfig& config,
                           const ProcedureObserver& observer, CalibrateResult& result);

/// Current at the first motion under a slow ramp, at several angles, both ways.
Result<void> calibrateStaticFriction(devices::Device& device, const CalibrateConfig& config,
                                     const ProcedureObserver& observer, CalibrateResult& result);

/// The proposed value of a parameter, or else the one on the device.
Result<double> proposedOrPresent(devices::Device& device, const CalibrateResult& result,
                                 const std::string& name);

} // namespace halbench::app
