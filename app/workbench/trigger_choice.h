#pragma once

#include "control/signals/trigger.h"

#include <string>

namespace halbench::app {

/// The oscilloscope trigger of the Monitor as a project keeps it, in SI.
struct TriggerChoice {
    bool isOn = false;
    std::string source; ///< name of a signal; empty: a change of the set-point
    control::TriggerMode mode = control::TriggerMode::Auto;
    control::TriggerSlope slope = control::TriggerSlope::Rising;
    double level = 0.0;
    double hysteresis = 0.0;
    double window_s = 1.0;
    double preTrigger_ratio = 0.25;
    double holdOff_s = 0.0;
    bool isBoard = false; ///< the board's own capture, instead of the live samples

    bool operator==(const TriggerChoice&) const = default;
};

} // namespace halbench::app
