#include "devices/open_device.h"

#include "devices/device_uri.h"
#include "devices/simulated/simulated_device.h"

#include <fmt/format.h>

namespace halbench::devices {

Result<std::unique_ptr<Device>> openDevice(const std::string& text, const OpenOptions& options) {
    const Result<DeviceUri> uri = parseDeviceUri(text);
    if (!uri) {
        return failure(uri.error());
    }
    if (uri->scheme == "sim") {
        return openSimulatedDevice(*uri, options);
    }
    return failure(ErrorCode::UnknownName,
                   fmt::format("device '{}': '{}:' is not built in this version", text, uri->scheme),
                   "known are sim:htm, tcp:HOST:PORT and replay:FILE");
}

std::vector<DeviceListing> listDevices() {
    return listSimulatedDevices();
}

} // namespace halbench::devices
