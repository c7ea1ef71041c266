#include "devices/open_device.h"

#include "devices/acquisition/replay_device.h"
#include "devices/device_uri.h"
#include "devices/port_address.h"
#include "devices/simulated/simulated_device.h"
#include "devices/transport/port_listing.h"
#include "devices/transport/tcp_transport.h"
#include "devices/transport/udp_transport.h"
#include "devices/xcp/xcp_device.h"

#include <QtCore/QStandardPaths>

#include <fmt/format.h>

#include <array>

namespace halbench::devices {

namespace {

Result<std::unique_ptr<Transport>> networkTransport(const DeviceUri& uri) {
    const Result<NetworkAddress> address = parseNetworkAddress(uri.address);
    if (!address) {
        return failure(address.error());
    }
    if (Result<void> plain = refuseOptions(uri); !plain) {
        return failure(plain.error());
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
    if (uri.scheme == "usb" || uri.scheme == "hid") {
        return makeUsbTransport(uri);
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

DeviceListing listingOf(const PortListing& port) {
    constexpr std::array Transports = {"serial", "usb", "hid"};
    DeviceListing listing;
    listing.uri = port.uri.empty()
                      ? fmt::format("usb:{}", UsbName{port.vendor, port.product, port.serial}.text())
                      : port.uri;
    listing.transport = Transports[static_cast<std::size_t>(port.kind)];
    listing.id = port.serial;
    listing.name = port.name;
    listing.isAvailable = port.reason.empty();
    listing.reason = port.reason;
    listing.hint = port.hint;
    return listing;
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
    if (uri->scheme == "replay") {
        return openReplayDevice(uri->text, uri->address);
    }
    return openBoard(*uri, options);
}

std::vector<DeviceListing> listDevices() {
    std::vector<DeviceListing> devices = listSimulatedDevices();
    for (const PortListing& port : listPorts()) {
        devices.push_back(listingOf(port));
    }
    return devices;
}

} // namespace halbench::devices
