#pragma once

#include "devices/transport/octet_port.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace halbench::devices {

/// How a serial port is opened; always 8 data bits, no parity, 1 stop bit, no flow control.
struct SerialSettings {
    std::string device; ///< "/dev/ttyACM0"
    int baud = 115200;
    bool isLowLatency = true; ///< USB adapters otherwise collect octets for 16 ms; ignored where unknown
    /// The DTR line, whose rise resets an Arduino; absent: as the system sets it (on).
    std::optional<bool> isDtrOn;
};

/// A serial port in a thread of its own, opened exclusively. Unplugging is told once, whatever the driver
/// does. Thread: one, the connection's.
class SerialPort : public OctetPort {
public:
    explicit SerialPort(SerialSettings settings);
    ~SerialPort() override;
    SerialPort(const SerialPort&) = delete;
    SerialPort& operator=(const SerialPort&) = delete;

    Result<void> open(OctetInbox& inbox) override;
    void close() noexcept override;
    Result<void> write(std::span<const std::uint8_t> octets) override;
    std::string description() const override { return "serial:" + m_settings.device; }

private:
    class Line;

    SerialSettings m_settings;
    std::unique_ptr<Line> m_line;
};

} // namespace halbench::devices
