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

/// As findRoom(), of a platen that stands straight enough: turned so far that it may lean on its end stop, it
/// is turned back first, since the motion would leave the window or the loop wind up against the stop.
/// Errors: of findRoom() and recordMotion().
Result<PlatenRoom> findStraightRoom(devices::Device& device, const PlatenBoard& board,
                                    const ProcedureObserver& observer, bool& wasHomed);

/// Homes when needed, arms in position mode, follows the legs and disarms; the caller holds the RestoreGuard.
/// Errors: Refused (no zero, coils too warm), SafetyStop, of the device, of the abort.
Result<PlatenMotion> recordMotion(devices::Device& device, const PlatenBoard& board,
                                  const std::vector<MotionLeg>& legs, const ProcedureObserver& observer);

/// Short pulses of one coil after the other in both directions, with the platen at rest before each: the
/// field of the currents appears at the chips before anything can move. Errors: as above.
Result<PlatenMotion> recordPulses(devices::Device& device, const PlatenBoard& board,
                                  const ProcedureObserver& observer);

} // namespace halbench::app
