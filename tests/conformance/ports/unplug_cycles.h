#pragma once

#include "devices/transport/hid_port.h"
#include "devices/transport/message_stream.h"
#include "tests/app/session/unplug_cycles.h"
#include "tests/conformance/ports/mock_usb.h"

namespace halbench::app {

/// A mock USB device as the port that a board is served on, plugged in while the port lives. The device
/// itself is not this one's: whoever had it open still asks it something after it was unplugged.
template <typename Mock>
class MockPort : public devices::ServerPort {
public:
    explicit MockPort(Mock& mock) : m_parser(devices::MaxCommandOctets), m_mock(mock) {}
    ~MockPort() override { unplug(); }

    std::string address() const override { return m_mock.node(); }
    void waitForTraffic(int timeout_ms) const override { m_taken = take(1e-3 * timeout_ms); }
    void exchange(devices::ServedBoard& board) override {
        m_parser.feed(m_taken);
        for (auto message = m_parser.next(); message && *message; message = m_parser.next()) {
            board.receive((*message)->packet);
        }
        std::uint16_t counter = 0;
        while (board.transmit(m_packet, counter)) {
            devices::Octets stream;
            devices::appendMessage(stream, counter, m_packet);
            deliver(stream);
        }
    }

private:
    devices::Octets take(double time_s) const;
    void deliver(const devices::Octets& stream);
    void unplug();

    devices::MessageParser m_parser;
    Mock& m_mock;
    mutable devices::Octets m_taken; ///< since the last exchange
    std::vector<std::uint8_t> m_packet;
};

template <>
inline devices::Octets MockPort<devices::MockBulkBoard>::take(double time_s) const {
    return m_mock.takenWithin(time_s);
}
template <>
inline void MockPort<devices::MockBulkBoard>::deliver(const devices::Octets& stream) {
    m_mock.deliver(stream);
}
template <>
inline void MockPort<devices::MockBulkBoard>::unplug() {
    m_mock.unplug(devices::MockBulkBoard::Departure::NoDevice);
}
template <>
inline devices::Octets MockPort<devices::MockHidBoard>::take(double time_s) const {
    devices::Octets octets;
    for (const devices::Octets& report : m_mock.takenWithin(time_s)) {
        const auto part = devices::octetsOf(std::span(report).subspan(1)); // behind the report number
        octets.insert(octets.end(), part.begin(), part.end());
    }
    return octets;
}
template <>
inline void MockPort<devices::MockHidBoard>::deliver(const devices::Octets& stream) {
    for (const devices::HidReport& report : devices::reportsFor(stream)) {
        m_mock.deliver({report.begin(), report.end()});
    }
}

template <>
inline void MockPort<devices::MockHidBoard>::unplug() {
    m_mock.unplug();
}

/// Plugged in under another number each time, as a system does it.
class UnplugPorts : public UnplugCycles {
protected:
    static constexpr int FirstPlace = 3;

    template <typename Mock>
    void runMock(const std::string& address, int cycles) {
        const devices::MockMachine machine;
        std::vector<std::unique_ptr<Mock>> mocks;
        PluggableBoard board([&]() -> std::unique_ptr<devices::ServerPort> {
            mocks.push_back(
                std::make_unique<Mock>(machine, FirstPlace + static_cast<int>(mocks.size()), "HB-17"));
            return std::make_unique<MockPort<Mock>>(*mocks.back());
        });
        run(
            board, [&] { return address; }, cycles);
        session.end(); // before its device
    }
    void runBulk(int cycles) { runMock<devices::MockBulkBoard>("usb:1209:0001", cycles); }
    void runHid(int cycles) { runMock<devices::MockHidBoard>("hid:1209:0001", cycles); }
};

} // namespace halbench::app
