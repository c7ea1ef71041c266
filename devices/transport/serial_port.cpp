#include "devices/transport/serial_port.h"

#include "devices/transport/serial_line.h"

#include <fmt/format.h>

namespace halbench::devices {

SerialPort::SerialPort(SerialSettings settings) : m_settings(std::move(settings)) {}

SerialPort::~SerialPort() = default;

Result<void> SerialPort::open(OctetInbox& inbox) {
    close();
    auto line = std::make_unique<Line>(m_settings, inbox);
    Result<void> opened = line->start();
    if (opened) {
        m_line = std::move(line);
    }
    return opened;
}

void SerialPort::close() noexcept {
    m_line.reset();
}

Result<void> SerialPort::write(std::span<const std::uint8_t> octets) {
    if (!m_line) {
        return failure(ErrorCode::DeviceLost, fmt::format("{} is not open", description()), "connect again");
    }
    return m_line->write(octets);
}

} // namespace halbench::devices
