#pragma once

#include "tests/conformance/ports/mock_usb.h"

#include <optional>

namespace halbench::devices {

/// A serial port that the mock machine's system knows: a pseudo terminal that also answers what these do not,
/// the driver's latency and the modem lines.
class MockSerialPort : public MockNode {
public:
    /// `name` "ttyACM0" is a board's own USB port 1209:0002, `name` "ttyS0" the machine's. `type` of a UART:
    /// "0" is one that is announced and not there.
    MockSerialPort(const MockMachine& machine, const std::string& name, const std::string& type = {});
    ~MockSerialPort() override;

    /// The board's end of the line.
    int line() const { return const_cast<MockSerialPort*>(this)->master().number(); }
    bool isLowLatency();
    std::optional<bool> dtr(); ///< as it was set last; absent: never

protected:
    bool onIoctl(UMockdevIoctlClient* client) override;
    bool onRead(UMockdevIoctlClient* client) override { return pass(client); }
    bool onWrite(UMockdevIoctlClient* client) override { return pass(client); }

private:
    static bool pass(UMockdevIoctlClient* client);

    const MockMachine* m_machine;
    std::vector<std::string> m_places; ///< in the device tree, the parents first
    int m_flags = 0;
    std::optional<bool> m_dtr;
};

} // namespace halbench::devices
