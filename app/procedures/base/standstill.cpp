#include "app/procedures/base/standstill.h"

#include "app/procedures/base/axis_choice.h"
#include "app/procedures/base/procedure_steps.h"

#include <cmath>
#include <string>

namespace halbench::app {

Result<void> awaitStandstill(devices::Device& device, const devices::AxisSpec& axis,
                             const ProcedureObserver& observer) {
    constexpr double Still_rad_s = 0.15; // one count that flickers looks like 0.11 rad/s
    constexpr double Patience_s = 10.0;
    constexpr double Piece_s = 0.1;
    const std::string names[] = {signalOf(device.catalogue(), axis.roles.speed)};
    if (device.catalogue().findSignal(names[0]) == nullptr) {
        return {};
    }
    int still = 0;
    for (double waited_s = 0.0; waited_s < Patience_s && still < 2; waited_s += Piece_s) {
        const auto speed_rad_s = device.readSignals(names);
        if (!speed_rad_s) {
            return failure(speed_rad_s.error());
        }
        still = std::fabs(speed_rad_s->front()) < Still_rad_s ? still + 1 : 0;
        if (still < 2) {
            if (auto waited = waitObserved(device, observer, Piece_s, 0.0, 0.0, "waiting for standstill");
                !waited) {
                return waited;
            }
        }
    }
    return {};
}

} // namespace halbench::app
