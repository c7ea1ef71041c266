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
    /// Takes an option out, for those who read the others.
    std::optional<std::string> takeOption(const std::string& key);
};

/// Errors: InvalidInput with the place of the first wrong character; UnknownName for an unknown scheme.
Result<DeviceUri> parseDeviceUri(const std::string& text);

/// The address with the option `a2l=FILE` in place of one it may have had. '&' and '%' of the file's name are
/// written %26 and %25. Errors: as parseDeviceUri(); InvalidInput for a device that needs no description.
Result<std::string> withDescription(const std::string& address, const std::string& path);
/// The file name that such an option stands for.
std::string fileOfOption(const std::string& value);

} // namespace halbench::devices
