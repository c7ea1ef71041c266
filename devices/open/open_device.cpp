#include "devices/open/open_device.h"

#include "devices/device_uri.h"
#include "devices/formats/replay_device.h"
#include "devices/interruption.h"
#include "devices/open/port_address.h"
#include "devices/simulated/registry/simulated_device.h"
#include "devices/transport/port_listing.h"
#include "devices/transport/tcp_transport.h"
#include "devices/transport/udp_transport.h"
#include "devices/xcp/a2l.h"
#include "devices/xcp/xcp_device.h"

#include <QtCore/QFile>
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

/// A board's description from a file (`?a2l=FILE`). Errors: FileSystem, InvalidInput with the file.
Result<std::string> readDescriptionFile(const std::string& path) {
    QFile file(QString::fromStdString(path));
    if (!file.open(QIODevice::ReadOnly)) {
        return failure(
            ErrorCode::FileSystem,
            fmt::format("the description '{}' cannot be read: {}", path, file.errorString().toStdString()),
            "give the A2L file for the device's firmware");
    }
    if (file.size() > static_cast<qint64>(xcp::MaxA2lSize)) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("the description '{}' has {} bytes", path, file.size()),
                       fmt::format("at most {} are read", xcp::MaxA2lSize));
    }
    std::string text = file.readAll().toStdString();
    if (const Result<xcp::A2lDescription> description = xcp::parseA2l(text); !description) {
        return failure(ErrorCode::InvalidInput, fmt::format("{}: {}", path, description.error().message),
                       "give the A2L file for the device's firmware");
    }
    return text;
}

Result<std::unique_ptr<Device>> openBoard(DeviceUri uri, const OpenOptions& options) {
    XcpDeviceOptions device;
    if (const std::optional<std::string> file = uri.takeOption("a2l")) {
        Result<std::string> text = readDescriptionFile(fileOfOption(*file));
        if (!text) {
            return failure(text.error());
        }
        device.description = *std::move(text);
    }
    Result<std::unique_ptr<Transport>> transport = makeTransport(uri);
    if (!transport) {
        return failure(transport.error());
    }
    device.identity.uri = uri.text;
    device.identity.transport = uri.scheme;
    device.interruptSignal = options.interruptSignal;
    device.orders = options.orders;
    device.onMessage = options.onMessage;
    device.cacheFolder = options.cacheFolder;
    device.measuresClock = true;
    return openXcpDevice(*std::move(transport), std::move(device));
}

/// A long recording is given up while it is read, as a board while it is opened.
Result<std::unique_ptr<Device>> openReplay(const DeviceUri& uri, const OpenOptions& options) {
    const auto checkAbort = [&]() -> Result<void> {
        const int signal = options.interruptSignal != nullptr ? options.interruptSignal->load() : 0;
        if (signal != 0 || (options.orders && options.orders->isLeaving)) {
            return failure(signal != 0 ? codeOfSignal(signal) : ErrorCode::Interrupted,
                           fmt::format("{}: connection attempt ended", uri.text));
        }
        return {};
    };
    return openReplayDevice(uri.text, uri.address, checkAbort, options.onProgress);
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
        return openReplay(*uri, options);
    }
    return openBoard(*uri, options);
}

std::vector<DeviceListing> listBuiltInDevices() {
    return listSimulatedDevices();
}

std::vector<DeviceListing> listDevices() {
    std::vector<DeviceListing> devices = listBuiltInDevices();
    for (const PortListing& port : listPorts()) {
        devices.push_back(listingOf(port));
    }
    return devices;
}

} // namespace halbench::devices
