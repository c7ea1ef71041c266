#pragma once

#include "control/base/result.h"
#include "devices/transport/octet_inbox.h"

#include <cstdint>
#include <span>
#include <string>

namespace halbench::devices {

/// A way for octets with a thread of its own: a serial line, a pair of USB endpoints, HID reports. Thread:
/// one, the connection's.
class OctetPort {
public:
    virtual ~OctetPort() = default;

    /// From now on what arrives goes into the inbox, from the port's own thread; so does the error that ends
    /// it. Errors: DeviceLost (not there, not allowed, busy: each in its own words).
    virtual Result<void> open(OctetInbox& inbox) = 0;
    /// Nothing is put into the inbox after it returns. A closed port may be opened again.
    virtual void close() noexcept = 0;
    /// Hands octets over; waits while the other side takes none. Error: DeviceLost.
    virtual Result<void> write(std::span<const std::uint8_t> octets) = 0;
    /// The address it was named by: "serial:/dev/ttyACM0".
    virtual std::string description() const = 0;
};

} // namespace halbench::devices
