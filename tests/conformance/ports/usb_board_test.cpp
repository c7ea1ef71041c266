#include "devices/device_uri.h"
#include "devices/open_device.h"
#include "devices/simulated/simulated_device.h"
#include "devices/transport/board_server.h"
#include "devices/transport/hid_port.h"
#include "devices/transport/message_stream.h"
#include "tests/conformance/ports/mock_usb.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace halbench::devices {
namespace {

constexpr std::size_t MaxPacket = 0xFFFF;

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

void useLikeAnyDevice(const std::string& uri) {
    const auto device = openDevice(uri, {});
    ASSERT_TRUE(device) << device.error().message;
    EXPECT_EQ((*device)->info().model, "htm");
    EXPECT_FALSE((*device)->info().isSimulated) << "what is behind a line may move: it needs consent";
    const ParameterValue gain{"gain.kp", 12.5};
    ASSERT_TRUE((*device)->writeParameters({&gain, 1}));
    EXPECT_DOUBLE_EQ((*device)->readParameters({&gain.name, 1}).value()[0], 12.5);
    Recording recording;
    ASSERT_TRUE((*device)->startStream({{"position", "speed"}, 100.0},
                                       [&](const SampleBlockPtr& block) { recording.append(*block); }));
    ASSERT_TRUE((*device)->arm());
    ASSERT_TRUE((*device)->clock().waitFor(0.3));
    (*device)->stop();
    EXPECT_TRUE((*device)->state().isStopLatched);
    (*device)->stopStream();
    EXPECT_EQ((*device)->statistics().packetsLost, 0U);
    EXPECT_GT(recording.rows(), 10U);
}

TEST(UsbBoard, worksOverBulkEndpointsLikeTheEmbeddedBoard) {
    const MockMachine machine;
    MockBulkBoard mock(machine, 4, "HB-17");
    std::atomic<bool> hasEnded{false};
    std::thread board([&] {
        serveMotor([&](const Octets& octets) { mock.deliver(octets); },
                   [&] { return mock.takenWithin(0.001); }, hasEnded);
    });
    useLikeAnyDevice("usb:1209:0001:HB-17");
    hasEnded = true;
    board.join();
}

TEST(HidBoard, worksOverReportsLikeTheEmbeddedBoard) {
    const MockMachine machine;
    MockHidBoard mock(machine, 3, "HB-9");
    std::atomic<bool> hasEnded{false};
    const auto send = [&](const Octets& octets) {
        for (const HidReport& report : reportsFor(octets)) {
            mock.deliver({report.begin(), report.end()});
        }
    };
    const auto take = [&] {
        Octets octets;
        for (const Octets& report : mock.takenWithin(0.001)) {
            const auto part = octetsOf(std::span(report).subspan(1)); // behind the report number
            octets.insert(octets.end(), part.begin(), part.end());
        }
        return octets;
    };
    std::thread board([&] { serveMotor(send, take, hasEnded); });
    useLikeAnyDevice("hid:1209:0001");
    hasEnded = true;
    board.join();
}

} // namespace
} // namespace halbench::devices
