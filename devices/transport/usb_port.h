#pragma once

#include "devices/transport/octet_port.h"
#include "devices/transport/port_listing.h"

#include <memory>

namespace halbench::devices {

/// A pair of USB bulk endpoints (resources/help/protocol.md 3.4): several transfers wait for the device at
/// any time, so that it never waits for us. A kernel driver is detached while it is open. Thread: one, the
/// connection's.
class UsbPort : public OctetPort {
public:
    explicit UsbPort(UsbName name);
    ~UsbPort() override;
    UsbPort(const UsbPort&) = delete;
    UsbPort& operator=(const UsbPort&) = delete;

    Result<void> open(OctetInbox& inbox) override;
    void close() noexcept override;
    Result<void> write(std::span<const std::uint8_t> octets) override;
    std::string description() const override { return "usb:" + m_name.text(); }

private:
    class Pipe;

    UsbName m_name;
    std::unique_ptr<Pipe> m_pipe;
};

} // namespace halbench::devices
