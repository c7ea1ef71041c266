#include "devices/transport/usb_port.h"

#include "devices/transport/usb_pipe.h"

#include <fmt/format.h>

namespace halbench::devices {

UsbPort::UsbPort(UsbName name) : m_name(std::move(name)) {}

UsbPort::~UsbPort() = default;

Result<void> UsbPort::open(OctetInbox& inbox) {
    close();
    const Result<PortListing> port = findPort(listPorts(), PortKind::UsbBulk, m_name);
    if (!port) {
        return failure(port.error());
    }
    auto pipe = std::make_unique<Pipe>(description(), inbox);
    Result<void> opened = pipe->open(*port);
    if (opened) {
        m_pipe = std::move(pipe);
    }
    return opened;
}

void UsbPort::close() noexcept {
    m_pipe.reset();
}

Result<void> UsbPort::write(std::span<const std::uint8_t> octets) {
    if (!m_pipe) {
        return failure(ErrorCode::DeviceLost, fmt::format("{} is not open", description()), "connect again");
    }
    return m_pipe->write(octets);
}

} // namespace halbench::devices
