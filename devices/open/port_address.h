#pragma once

#include "control/base/result.h"
#include "devices/device_uri.h"
#include "devices/transport/serial_port.h"
#include "devices/transport/sxi_codec.h"
#include "devices/transport/transport.h"

#include <memory>
#include <vector>

namespace halbench::devices {

/// `serial:/dev/ttyACM0?baud=115200`, read.
struct SerialAddress {
    SerialSettings settings;
    std::vector<SxiProfile> profiles; ///< in the order they are tried; one when the address says which
};

/// Errors: UnknownName (option, word), OutOfRange (baud, octet), InvalidInput (contradiction).
Result<SerialAddress> parseSerialAddress(const DeviceUri& uri);
Result<std::unique_ptr<Transport>> makeSerialTransport(const DeviceUri& uri);
/// `usb:VID:PID[:SERIAL]`, `hid:VID:PID[:SERIAL]`. Errors: InvalidInput, UnknownName (option).
Result<std::unique_ptr<Transport>> makeUsbTransport(const DeviceUri& uri);
/// An address that takes no options has none. Errors: UnknownName.
Result<void> refuseOptions(const DeviceUri& uri);

} // namespace halbench::devices
