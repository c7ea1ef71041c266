#pragma once

#include "devices/device_uri.h"
#include "devices/simulated/registry/simulated_device.h"
#include "devices/transport/board_server.h"
#include "devices/transport/hid_port.h"
#include "devices/transport/message_stream.h"
#include "tests/conformance/ports/mock_usb.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace halbench::devices {

inline constexpr std::size_t MaxPacket = 0xFFFF;

/// The simulated motor's own board behind a mock device: the bytes are those of a real one.
template <typename Send, typename Take>
void serveMotor(const Send& send, const Take& take, const std::atomic<bool>& hasEnded) {
    const auto board = makeSimulatedBoard(*parseDeviceUri("sim:htm?imperfections=off"), std::nullopt, {});
    ASSERT_TRUE(board);
    MessageParser parser(MaxPacket);
    const auto start = std::chrono::steady_clock::now();
    std::vector<std::uint8_t> packet;
    while (!hasEnded) {
        parser.feed(take());
        for (auto message = parser.next(); message && *message; message = parser.next()) {
            (*board)->receive((*message)->packet);
        }
        (*board)->advanceTo(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        for (packet.resize(MaxPacket); (packet.resize((*board)->transmit(packet)), !packet.empty());
             packet.resize(MaxPacket)) {
            Octets stream;
            appendMessage(stream, (*board)->messageCounter(), packet);
            send(stream);
        }
    }
}

/// The motor behind endpoints or reports while it lives.
class ServedMotor {
public:
    explicit ServedMotor(MockBulkBoard& mock)
        : m_thread([this, &mock] {
              serveMotor([&](const Octets& octets) { mock.deliver(octets); },
                         [&] { return mock.takenWithin(0.001); }, m_hasEnded);
          }) {}
    explicit ServedMotor(MockHidBoard& mock)
        : m_thread([this, &mock] {
              const auto send = [&](const Octets& octets) {
                  for (const HidReport& report : reportsFor(octets)) {
                      mock.deliver({report.begin(), report.end()});
                  }
              };
              serveMotor(
                  send, [&] { return octetsIn(mock.takenWithin(0.001)); }, m_hasEnded);
          }) {}
    ~ServedMotor() {
        m_hasEnded = true;
        m_thread.join();
    }
    ServedMotor(const ServedMotor&) = delete;
    ServedMotor& operator=(const ServedMotor&) = delete;

private:
    static Octets octetsIn(const std::vector<Octets>& reports) {
        Octets all;
        for (const Octets& report : reports) {
            const auto carried = octetsOf(std::span(report).subspan(1)); // behind the report number
            all.insert(all.end(), carried.begin(), carried.end());
        }
        return all;
    }

    std::atomic<bool> m_hasEnded{false};
    std::thread m_thread;
};

} // namespace halbench::devices
