#pragma once

#include "control/base/result.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace halbench::devices {

/// A parsed device address: `sim:htm?seed=7&c=2e-3`, `tcp:HOST:PORT`, `serial:/dev/ttyACM0?baud=115200`,
/// `usb:VID:PID[:SERIAL]`, `hid:VID:PID[:SERIAL]`, `udp:HOST:PORT`, `replay:FILE`.
struct DeviceUri {
    std::string scheme;
    std::string address; ///< what stands between the first ':' and the '?'
    std::vector<std::pair<std::string, std::string>> options; ///< in the order written; keys are unique
    std::string text;                                         ///< as given

    std::optional<std::string> option(const std::string& key) const;
};

/// Errors: InvalidInput with the place of the first wrong character; UnknownName for an unknown scheme.
Result<DeviceUri> parseDeviceUri(const std::string& text);

} // namespace halbench::devices
