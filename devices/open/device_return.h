#pragma once

#include "devices/device.h"

#include <functional>
#include <memory>

namespace halbench::devices {

/// When a device that was lost is looked for, and when that is given up.
struct ReturnTimes {
    double first_s = 0.1;      ///< from the loss to the first look
    double growth_ratio = 1.6; ///< of the pause from look to look
    double longest_s = 2.0;    ///< pause between two looks
    /// A link that is lost again sooner than this after its return was not really back: two programs that
    /// take one board from each other would otherwise go on for ever.
    double settled_s = 5.0;
    int mostUnsettled = 3; ///< such returns in a row
};

/// Waits for one lost device to come back: looks for it now and then, and lets no other device and no other
/// firmware take its place. Knows no clock: the caller says what time it is. Thread: one.
class DeviceReturn {
public:
    /// Opens the device's address, or says why that cannot be done now.
    using Opener = std::function<Result<std::unique_ptr<Device>>()>;

    DeviceReturn(DeviceInfo former, Opener open, ReturnTimes times = {});

    /// The link broke. Error: Refused when it breaks again and again right after its return.
    Result<void> noteLost(double now_s);
    /// Opens the device when that is due. Null: it is not back yet. Errors, which end the waiting: Refused
    /// (another device answers, or this one has other firmware).
    Result<std::unique_ptr<Device>> look(double now_s);
    /// Why it is not back yet.
    const Error& reason() const { return m_reason; }

private:
    Result<void> checkIdentity(const DeviceInfo& found) const;

    DeviceInfo m_former;
    Opener m_open;
    ReturnTimes m_times;
    Error m_reason;
    double m_pause_s = 0.0;
    double m_next_s = 0.0;
    double m_returned_s = 0.0;
    bool m_hasReturned = false;
    int m_unsettled = 0;
};

} // namespace halbench::devices
