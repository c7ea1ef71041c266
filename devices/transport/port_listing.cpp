#include "devices/transport/port_listing.h"

#include "devices/transport/port_access.h"
#include "devices/transport/udev_handle.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cstring>
#include <fstream>
#include <functional>
#include <iterator>
#include <sstream>

namespace halbench::devices {

namespace {

/// Terminals of the screen and the like: dozens, none of them at a bus, each a walk through the system's
/// files.
constexpr const char* VirtualDevices = "/sys/devices/virtual/";

std::string words(const char* text) {
    return text == nullptr ? std::string() : std::string(text);
}

std::string attribute(udev_device* device, const char* name) {
    return words(udev_device_get_sysattr_value(device, name));
}

std::vector<std::uint8_t> octetsOf(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

int numberFrom(const std::string& text, int base) {
    int number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number, base);
    return number;
}

void forEach(udev* context, const char* subsystem, const std::function<void(udev_device*)>& take) {
    const UdevHandle<udev_enumerate> list(udev_enumerate_new(context));
    if (!list || udev_enumerate_add_match_subsystem(list.get(), subsystem) < 0 ||
        udev_enumerate_scan_devices(list.get()) < 0) {
        return;
    }
    udev_list_entry* entry = nullptr;
    udev_list_entry_foreach(entry, udev_enumerate_get_list_entry(list.get())) {
        const std::string path = words(udev_list_entry_get_name(entry));
        if (path.starts_with(VirtualDevices)) {
            continue;
        }
        const UdevHandle<udev_device> device(udev_device_new_from_syspath(context, path.c_str()));
        if (device) {
            take(device.get());
        }
    }
}

void fillUsb(PortListing& port, udev_device* device) {
    port.vendor = static_cast<std::uint16_t>(numberFrom(attribute(device, "idVendor"), 16));
    port.product = static_cast<std::uint16_t>(numberFrom(attribute(device, "idProduct"), 16));
    port.serial = attribute(device, "serial");
    port.bus = numberFrom(attribute(device, "busnum"), 10);
    port.address = numberFrom(attribute(device, "devnum"), 10);
    const std::string maker = attribute(device, "manufacturer");
    const std::string product = attribute(device, "product");
    port.name = maker + (maker.empty() || product.empty() ? "" : " ") + product;
}

std::string usbUri(const char* scheme, const PortListing& port) {
    return fmt::format("{}:{}", scheme, UsbName{port.vendor, port.product, port.serial}.text());
}

/// Without permission it cannot be opened; in use by another program it probably cannot.
void judge(PortListing& port, bool isInUse) {
    std::optional<PortTrouble> trouble = troubleOf(port.node);
    if (!trouble && isInUse) {
        trouble = busyTrouble(port.node);
    }
    if (trouble) {
        port.reason = trouble->reason;
        port.hint = trouble->hint;
    }
}

/// The name that stays when ports are numbered anew.
std::string stableLink(udev_device* device) {
    std::istringstream links(words(udev_device_get_property_value(device, "DEVLINKS")));
    for (std::string link; links >> link;) {
        if (link.rfind("/dev/serial/by-id/", 0) == 0) {
            return link;
        }
    }
    return words(udev_device_get_devnode(device));
}

/// The terminals that the kernel and the log-in talk through, as "tty0 ttyS0".
std::string consolesOf(udev* context) {
    const UdevHandle<udev_device> console(udev_device_new_from_subsystem_sysname(context, "tty", "console"));
    return console ? " " + attribute(console.get(), "active") + " " : std::string();
}

void judgeSerial(PortListing& port, bool isConsole) {
    judge(port, holderOf(port.node).has_value());
    if (port.reason.empty() && isConsole) {
        port.reason = "it is the console of this machine";
        port.hint = "use another port, or start the computer without 'console=' for this one";
    }
}

void addSerial(std::vector<PortListing>& ports, udev_device* device, const std::string& consoles) {
    udev_device* const parent = udev_device_get_parent(device);
    const bool isNobodys = parent == nullptr || udev_device_get_devnode(device) == nullptr;
    // A PC announces dozens of UARTs that it has not: their type is unknown.
    if (isNobodys || attribute(device, "type") == "0") {
        return;
    }
    PortListing port;
    port.node = words(udev_device_get_devnode(device));
    port.uri = "serial:" + stableLink(device);
    if (udev_device* usb = udev_device_get_parent_with_subsystem_devtype(device, "usb", "usb_device")) {
        fillUsb(port, usb);
    }
    const std::string name = words(udev_device_get_sysname(device));
    judgeSerial(port, consoles.find(" " + name + " ") != std::string::npos);
    ports.push_back(std::move(port));
}

bool isSerialFunction(udev_device* interface) {
    return attribute(interface, "bInterfaceClass") == "02" &&
           attribute(interface, "bInterfaceSubClass") == "02";
}

/// The drivers of the usual USB serial adapters, by vendor. Their interfaces look like a board's: of the
/// vendor's class, with a bulk pair.
const char* serialAdapterDriver(std::uint16_t vendor) {
    switch (vendor) {
    case 0x0403:
        return "ftdi_sio";
    case 0x067B:
        return "pl2303";
    case 0x10C4:
        return "cp210x";
    case 0x1A86:
        return "ch341";
    default:
        return nullptr;
    }
}

/// A USB serial port whose driver is missing shows no tty: it is told instead.
void addDriverless(std::vector<PortListing>& ports, PortListing port, const char* driver) {
    port.reason = "its serial port has no driver";
    port.hint = fmt::format("load it: sudo modprobe {}", driver);
    ports.push_back(std::move(port));
}

/// A driver of the system is no trouble for who names the address, but its function is gone meanwhile.
void judgeBulk(PortListing& port) {
    judge(port, port.driver == "usbfs");
    if (port.reason.empty() && !port.driver.empty()) {
        port.reason = fmt::format("held by the kernel driver '{}'", port.driver);
        port.hint = fmt::format(
            "to use it as device, connect to {}: the driver is detached until you disconnect", port.uri);
    }
}

void addInterface(std::vector<PortListing>& ports, udev_device* interface) {
    udev_device* const usb = udev_device_get_parent_with_subsystem_devtype(interface, "usb", "usb_device");
    if (usb == nullptr || words(udev_device_get_devtype(interface)) != "usb_interface") {
        return;
    }
    PortListing port;
    fillUsb(port, usb);
    port.node = words(udev_device_get_devnode(usb));
    port.driver = words(udev_device_get_driver(interface));
    const bool isCdc = isSerialFunction(interface);
    const char* const adapter = isCdc ? "cdc_acm" : serialAdapterDriver(port.vendor);
    const int number = numberFrom(attribute(interface, "bInterfaceNumber"), 16);
    const auto pair = bulkPairOf(octetsOf(words(udev_device_get_syspath(usb)) + "/descriptors"), number);
    if (adapter != nullptr && (isCdc || pair)) {
        if (port.driver.empty()) {
            addDriverless(ports, std::move(port), adapter);
        }
    } else if (pair) {
        port.kind = PortKind::UsbBulk;
        port.ends = *pair;
        port.uri = usbUri("usb", port);
        judgeBulk(port);
        ports.push_back(std::move(port));
    }
}

void addHid(std::vector<PortListing>& ports, udev_device* device) {
    udev_device* const hid = udev_device_get_parent_with_subsystem_devtype(device, "hid", nullptr);
    udev_device* const usb = udev_device_get_parent_with_subsystem_devtype(device, "usb", "usb_device");
    if (hid == nullptr || usb == nullptr ||
        !isVendorReport(octetsOf(words(udev_device_get_syspath(hid)) + "/report_descriptor"))) {
        return; // keyboards and mice are nobody's actuators
    }
    PortListing port;
    port.kind = PortKind::Hid;
    fillUsb(port, usb);
    port.node = words(udev_device_get_devnode(device));
    port.uri = usbUri("hid", port);
    judge(port, holderOf(port.node).has_value());
    ports.push_back(std::move(port));
}

const char* kindName(PortKind kind) {
    constexpr std::array Names = {"serial port", "USB bulk device", "HID device"};
    return Names[static_cast<std::size_t>(kind)];
}

Error noSuchPort(const std::vector<PortListing>& ports, PortKind kind, const UsbName& name) {
    const std::string what = fmt::format("no {} {} is plugged in", kindName(kind), name.text());
    for (const PortListing& port : ports) {
        if (port.vendor != name.vendor || port.product != name.product) {
            continue;
        }
        if (port.kind != kind) {
            return {ErrorCode::DeviceLost, fmt::format("{}: it is a {}", what, kindName(port.kind)),
                    port.uri.empty() ? port.hint : fmt::format("name it {}", port.uri)};
        }
        return {ErrorCode::DeviceLost,
                fmt::format("{}: the connected device has the serial number '{}'", what, port.serial),
                fmt::format("plug in the correct device, or use {}", port.uri)};
    }
    return {ErrorCode::DeviceLost, what, "plug it in; 'halbench devices' lists the addresses"};
}

} // namespace

std::vector<PortListing> listPorts() {
    std::vector<PortListing> ports;
    const UdevHandle<udev> context(udev_new());
    if (!context) {
        return ports;
    }
    const std::string consoles = consolesOf(context.get());
    forEach(context.get(), "tty", [&](udev_device* device) { addSerial(ports, device, consoles); });
    forEach(context.get(), "usb", [&](udev_device* device) { addInterface(ports, device); });
    forEach(context.get(), "hidraw", [&](udev_device* device) { addHid(ports, device); });
    return ports;
}

std::string UsbName::text() const {
    return fmt::format("{:04x}:{:04x}{}{}", vendor, product, serial.empty() ? "" : ":", serial);
}

Result<UsbName> parseUsbName(const std::string& text) {
    UsbName name;
    const std::size_t first = text.find(':');
    const std::size_t second = first == std::string::npos ? first : text.find(':', first + 1);
    const auto isHex = [](std::string_view digits, std::uint16_t& value) {
        const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
        return digits.size() <= 4 && read.ec == std::errc{} && read.ptr == digits.data() + digits.size();
    };
    const std::string_view view(text);
    if (first == std::string::npos || !isHex(view.substr(0, first), name.vendor) ||
        !isHex(view.substr(first + 1, second == std::string::npos ? second : second - first - 1),
               name.product)) {
        return failure(ErrorCode::InvalidInput, fmt::format("'{}' is not VID:PID[:SERIAL]", text),
                       "write both numbers in hexadecimal digits, like 1209:0001");
    }
    name.serial = second == std::string::npos ? std::string() : text.substr(second + 1);
    return name;
}

Result<PortListing> findPort(const std::vector<PortListing>& ports, PortKind kind, const UsbName& name) {
    const PortListing* found = nullptr;
    for (const PortListing& port : ports) {
        const bool isNamed = port.kind == kind && port.vendor == name.vendor &&
                             port.product == name.product &&
                             (name.serial.empty() || port.serial == name.serial);
        if (isNamed && found != nullptr && found->node != port.node) {
            return failure(ErrorCode::DeviceLost,
                           fmt::format("several devices {} are plugged in", name.text()),
                           fmt::format("use {} or {}", found->uri, port.uri));
        }
        found = isNamed ? &port : found;
    }
    if (found == nullptr) {
        return failure(noSuchPort(ports, kind, name));
    }
    return *found;
}

} // namespace halbench::devices
