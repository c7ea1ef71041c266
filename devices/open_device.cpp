#include "devices/open_device.h"

#include "devices/acquisition/replay_device.h"
#include "devices/device_uri.h"
#include "devices/simulated/simulated_device.h"
#include "devices/transport/tcp_transport.h"
#include "devices/xcp/xcp_device.h"

#include <fmt/format.h>

namespace halbench::devices {

namespace {

Result<std::unique_ptr<Device>> openTcpDevice(const DeviceUri& uri, const OpenOptions& options) {
    const Result<TcpAddress> address = parseTcpAddress(uri.address);
    if (!address) {
        return failure(address.error());
    }
    if (!uri.options.empty()) {
        return failure(ErrorCode::UnknownName,
                       fmt::format("device '{}': unknown option '{}'", uri.text, uri.options.front().first),
                       "a tcp: address has no options");
    }
    XcpDeviceOptions device;
    device.identity.uri = uri.text;
    device.identity.transport = "tcp";
    device.interruptSignal = options.interruptSignal;
    device.onMessage = options.onMessage;
    return openXcpDevice(std::make_unique<TcpTransport>(*address), std::move(device));
}

} // namespace

Result<std::unique_ptr<Device>> openDevice(const std::string& text, const OpenOptions& options) {
    const Result<DeviceUri> uri = parseDeviceUri(text);
    if (!uri) {
        return failure(uri.error());
    }
    if (uri->scheme == "sim") {
        return openSimulatedDevice(*uri, options);
    }
    if (uri->scheme == "tcp") {
        return openTcpDevice(*uri, options);
    }
    if (uri->scheme == "replay") {
        return openReplayDevice(uri->text, uri->address);
    }
    return failure(ErrorCode::UnknownName,
                   fmt::format("device '{}': '{}:' is not built in this version", text, uri->scheme),
                   "known are sim:htm, tcp:HOST:PORT and replay:FILE");
}

std::vector<DeviceListing> listDevices() {
    return listSimulatedDevices();
}

} // namespace halbench::devices
