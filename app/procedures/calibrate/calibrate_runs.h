#pragma once

#include "app/procedures/base/procedure_steps.h"
#include "app/procedures/calibrate/calibrate_procedure.h"
#include "app/procedures/excite/spin_drive.h"
#include "app/procedures/identify/identify_plan.h"

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

/// Slow turns for the ellipse: under the spin current, or under what turns this motor between 20 % and 60 %
/// of the speed limit.
std::vector<PlateauRun> hallRuns(const CalibrateConfig& config, const PilotEstimate& motor);

/// Angle error per turn, orders 1 to 6, that the ellipse proposed in `result` leaves; proposes the board's
/// error map when it is known well enough to be worth it, else that it is switched off.
Result<void> calibrateAngleMap(devices::Device& device, const CalibrateConfig& config,
                               const ProcedureObserver& observer, const PilotEstimate& motor,
                               CalibrateResult& result);
/// Fast run-ups and coast-downs, one run in each direction.
std::vector<PlateauRun> angleMapRuns(const CalibrateConfig& config, const PilotEstimate& motor);

/// Times of the measurements at standstill, for the procedure and its prediction.
namespace standstill {
inline constexpr int StrayAngles = 3;
inline constexpr int StrayLevels = 17;
inline constexpr double StrayDwell_s = 0.12;
inline constexpr double StrayDuration_s = StrayLevels * StrayDwell_s + 0.05;
inline constexpr double StrayMeanSquare_ratio = 0.36;          ///< of the largest current, over the levels
inline constexpr double Pushes_s[] = {0.02, 0.04, 0.08, 0.16}; ///< until the rotor has turned by PushEnd_rad
inline constexpr double PushEnd_rad = 0.3;
inline constexpr double PushRest_s = 0.5;
inline constexpr double RampRate_A_per_s = 0.6;
inline constexpr double RampEnd_rad = 0.8; ///< travel at which the rotor is surely off
inline constexpr double RampRest_s = 0.6;
} // namespace standstill

/// Current at the first motion under a slow ramp, at several angles, both ways.
Result<void> calibrateStaticFriction(devices::Device& device, const CalibrateConfig& config,
                                     const ProcedureObserver& observer, CalibrateResult& result);

/// The proposed value of a parameter, or else the one on the device.
Result<double> proposedOrPresent(devices::Device& device, const CalibrateResult& result,
                                 const std::string& name);

} // namespace halbench::app
