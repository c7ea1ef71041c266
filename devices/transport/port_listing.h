#pragma once

#include "control/base/result.h"
#include "devices/transport/usb_descriptors.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace halbench::devices {

enum class PortKind { Serial, UsbBulk, Hid };

/// A port that is plugged in, as the system knows it. Nothing was opened to learn this.
struct PortListing {
    PortKind kind = PortKind::Serial;
    std::string node; ///< "/dev/ttyACM0", "/dev/bus/usb/001/004", "/dev/hidraw0"
    std::string uri;  ///< what opens it; empty when nothing of ours can
    std::string name; ///< maker and product
    std::string serial;
    std::uint16_t vendor = 0;
    std::uint16_t product = 0;
    int bus = 0; ///< on the USB
    int address = 0;
    BulkPair ends;      ///< of a USB bulk device
    std::string driver; ///< the kernel driver that holds these; empty: none
    std::string reason; ///< why it cannot be opened; empty when it can
    std::string hint;
};

/// Serial ports, USB devices with a vendor's pair of bulk endpoints, HID devices with a vendor's usage page.
/// Empty where the system tells of none. Thread: any but the window's, it reads many small files.
std::vector<PortListing> listPorts();

/// VID:PID[:SERIAL] of an address.
struct UsbName {
    std::uint16_t vendor = 0;
    std::uint16_t product = 0;
    std::string serial; ///< empty: any
    std::string text() const;
};
/// Errors: InvalidInput.
Result<UsbName> parseUsbName(const std::string& text);

/// The one port of this kind and name. Errors: DeviceLost (none, several, another serial number, another
/// kind).
Result<PortListing> findPort(const std::vector<PortListing>& ports, PortKind kind, const UsbName& name);

} // namespace halbench::devices
