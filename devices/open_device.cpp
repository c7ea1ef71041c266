#include "devices/open_device.h"

#include "devices/acquisition/replay_device.h"
#include "devices/device_uri.h"
#include "devices/port_address.h"
#include "devices/simulated/simulated_device.h"
#include "devices/transport/tcp_transport.h"
#include "devices/transport/udp_transport.h"
#include "devices/xcp/xcp_device.h"

#include <QtCore/QStandardPaths>

#include <fmt/format.h>

namespace halbench::devices {

namespace {

Result<std::unique_ptr<Transport>> networkTransport(const DeviceUri& uri) {
    const Result<NetworkAddress> address = parseNetworkAddress(uri.address);
    if (!address) {
        return failure(address.error());
    }
    if (!uri.options.empty()) {
        return failure(ErrorCode::UnknownName,
                       fmt::format("device '{}': unknown option '{}'", uri.text, uri.options.front().first),
                       fmt::format("a {}: address has no options", uri.scheme));
    }
    if (uri.scheme == "udp") {
        return std::make_unique<UdpTransport>(*address);
    }
    return std::make_unique<TcpTransport>(*address);
}

Result<std::unique_ptr<Transport>> makeTransport(const DeviceUri& uri) {
    if (uri.scheme == "serial") {
        return makeSerialTransport(uri);
    }
    return networkTransport(uri);
}

Result<std::unique_ptr<Device>> openBoard(const DeviceUri& uri, const OpenOptions& options) {
    Result<std::unique_ptr<Transport>> transport = makeTransport(uri);
    if (!transport) {
        return failure(transport.error());
    }
    XcpDeviceOptions device;
    device.identity.uri = uri.text;
    device.identity.transport = uri.scheme;
    device.interruptSignal = options.interruptSignal;
    device.orders = options.orders;
    device.onMessage = options.onMessage;
    device.cacheFolder = options.cacheFolder;
    device.measuresClock = true;
    return openXcpDevice(*std::move(transport), std::move(device));
}

} // namespace

std::string userCacheFolder() {
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation);
    return folder.isEmpty() ? std::string() : folder.toStdString() + "/halbench/boards";
}

Result<std::unique_ptr<Device>> openDevice(const std::string& text, const OpenOptions& options) {
    const Result<DeviceUri> uri = parseDeviceUri(text);
    if (!uri) {
        return failure(uri.error());
    }
    if (uri->scheme == "sim") {
        return openSimulatedDevice(*uri, options);
    }
    if (uri->scheme == "tcp" || uri->scheme == "udp" || uri->scheme == "serial") {
        return openBoard(*uri, options);
    }
    if (uri->scheme == "replay") {
        return openReplayDevice(uri->text, uri->address);
    }
    return failure(ErrorCode::UnknownName,
                   fmt::format("device '{}': '{}:' is not built in this version", text, uri->scheme),
                   "known are sim:htm, serial:DEVICE, tcp:HOST:PORT, udp:HOST:PORT and replay:FILE");
}

std::vector<DeviceListing> listDevices() {
    return listSimulatedDevices();
}

} // namespace halbench::devices
