#pragma once

#include "control/base/result.h"
#include "devices/device_options.h"

#include <string>
#include <vector>

namespace halbench::devices {

/// What a device is found by when it was plugged in elsewhere: the name of its port may be another one then,
/// and another device may have the old name.
struct RememberedPort {
    std::string uri;    ///< as it was named, with its options
    std::string serial; ///< serial number of the hardware; empty: it has none, or its port is not listed

    bool operator==(const RememberedPort&) const = default;
};

/// The port that an address names among those that are plugged in.
RememberedPort rememberPort(const std::string& uri, const std::vector<DeviceListing>& listed);

/// The address under which the device is now; without a serial number the one it had. Opens nothing.
/// Errors: DeviceLost (not plugged in; several with this serial number).
Result<std::string> addressNow(const RememberedPort& port, const std::vector<DeviceListing>& listed);

} // namespace halbench::devices
