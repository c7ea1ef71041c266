#pragma once

#include "app/actuators/planar/platen_legs.h"
#include "app/procedures/base/row_loss.h"

#include <vector>

namespace halbench::app {

/// A motion as recorded at the rate of the loop.
struct PlatenMotion {
    Recording recording;
    std::vector<ChipSample> samples; ///< one a row; the currents are those that flowed before it
    std::vector<models::CoilCurrents_A> current_A; ///< that flow from the row on
    RowLossCause loss;
    double duration_s = 0.0;
    bool wasHomed = true; ///< before it began
};

/// Legs from where the platen stands within its room.
using LegPlan = std::vector<MotionLeg> (*)(const PlatenRoom& room);

/// Homes when needed, arms in position mode, follows the legs and disarms; the caller holds the RestoreGuard.
/// The legs begin where the platen is held once it is armed: without current it has glided on since `room`
/// was found. Errors: Refused (no zero, coils too warm), SafetyStop, of the device, of the abort.
Result<PlatenMotion> recordMotion(devices::Device& device, const PlatenBoard& board, const PlatenRoom& room,
                                  LegPlan plan, const ProcedureObserver& observer);

/// The place of the platen and the travel around it; homes it when the board is not homed. A platen that has
/// no room where it stands, leans on its end stop in angle, or stands where chips without calibration do not
/// show its rotation is brought to lines with room first, the nearest or those of the middle. Errors: Refused
/// (no room there either), of recordMotion().
Result<PlatenRoom> findRoom(devices::Device& device, const PlatenBoard& board,
                            const ProcedureObserver& observer, bool& wasHomed);

/// A quarter of the bandwidth of every axis and no integral, until the values that it gives back are written
/// again: as stiff as usual, the law is unstable where the field of the coils reaches the chips and is not
/// compensated yet. Errors: of the device.
Result<std::vector<ParameterValue>> softenLaw(devices::Device& device);

/// Brings a platen to lines with room whose rotation the chips do not show where it stands: the board could
/// not brake it between the pulses. Errors: Refused (no room for the motion after the pulses, nothing was
/// armed), of findReach() and recordMotion().
Result<void> moveWhereRotationIsVisible(devices::Device& device, const PlatenBoard& board,
                                        const ProcedureObserver& observer, bool& wasHomed);

/// Short pulses of one coil after the other in both directions, with the platen at rest before each: the
/// field of the currents appears at the chips before anything can move. Errors: as above.
Result<PlatenMotion> recordPulses(devices::Device& device, const PlatenBoard& board,
                                  const ProcedureObserver& observer);

} // namespace halbench::app
