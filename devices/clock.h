#pragma once

#include "control/base/result.h"

namespace halbench::devices {

/// The time a procedure lives in. On hardware it is the host's steady clock; on a simulated device it is the
/// simulation's own time, which advances only inside waitFor(), as fast as the machine allows (or paced by
/// the wall clock with `--realtime`). Thread: the one that runs the procedure.
class Clock {
public:
    virtual ~Clock() = default;

    /// Seconds since the device was opened.
    virtual double now_s() const = 0;

    /// Lets device time pass while the link is served: streams deliver their blocks, the watchdog is fed,
    /// limits are guarded. Returns early with DeviceLost, SafetyStop, Interrupted or Terminated.
    virtual Result<void> waitFor(double duration_s) = 0;
};

} // namespace halbench::devices
