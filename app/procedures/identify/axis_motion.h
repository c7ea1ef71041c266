#pragma once

#include "app/procedures/base/procedure.h"
#include "app/procedures/base/row_loss.h"
#include "app/procedures/identify/axis_fit.h"
#include "devices/device.h"

#include <string>
#include <vector>

namespace halbench::app {

/// One piece of the reference of an axis, from where it is held: a constant speed and a sine on it.
struct AxisLeg {
    double speed = 0.0; ///< per second
    double duration_s = 0.0;
    double amplitude = 0.0; ///< of the sine: whole cycles
    double frequency_Hz = 0.0;
};

/// How one axis moves while it is identified: over its travel at two speeds, each both ways, with a sine that
/// leaves at least half of the speed, so that friction has one sign while the axis accelerates.
struct AxisPlan {
    devices::AxisSpec axis;
    double window = 0.0; ///< of the board: position from where the mode began, and speed
    double speedWindow = 0.0;
    double slowest = 0.0; ///< speed below which the motion is not used
    std::vector<AxisLeg> legs;
};

/// Parameter that sends the generator of an axis to the law (0); few boards have it.
std::string targetOf(const devices::AxisSpec& axis);

/// Within the board's windows of position and speed.
AxisPlan axisPlan(const devices::AxisSpec& axis, double window, double speedWindow);
double durationOf(const AxisPlan& plan);

/// Recorded motion of several axes that moved one after the other.
struct AxesMotion {
    std::vector<AxisRows> axes; ///< of each plan, from the first to the last row
    Recording recording;
    RowLossCause loss;
    double duration_s = 0.0;
};

/// Plans of the axes by the windows of the board. Errors: of the device.
Result<std::vector<AxisPlan>> axisPlans(devices::Device& device, const std::vector<devices::AxisSpec>& axes);

/// Arms in mode position, moves one axis after the other while the rest is held, disarms. Guarded from the
/// host by the board's own windows. The caller holds the RestoreGuard. Errors: SafetyStop, NotFinite,
/// InvalidInput (a signal is missing), of the device, of the abort.
Result<AxesMotion> recordAxes(devices::Device& device, const std::vector<AxisPlan>& plans,
                              const ProcedureObserver& observer);

} // namespace halbench::app
