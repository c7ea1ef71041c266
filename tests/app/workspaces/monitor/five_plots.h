#pragma once

#include "app/workspaces/monitor/monitor_view.h"

namespace halbench::app {

/// Field, angle with reference, speed, current and temperature of the simulated motor, a plot each: two more
/// than it shows at first.
inline MonitorView fivePlots() {
    MonitorView view;
    view.plots = {{{"hall.a", "hall.b"}, {}, {}},
                  {{"position", "reference"}, {}, {}},
                  {{"speed"}, {}, {}},
                  {{"current_command", "current.a", "current.b"}, {}, {}},
                  {{"coil_temperature.a", "coil_temperature.b"}, {}, {}}};
    return view;
}

} // namespace halbench::app
