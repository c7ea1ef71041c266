#include "devices/open_device.h"
#include "tests/devices/transport/served_board.h"
#include "tests/devices/transport/udp_pair.h"

#include <gtest/gtest.h>
#include <sys/socket.h>

namespace halbench::devices {
namespace {

struct Pair : UdpPair {
    Octets next() {
        Octets packet;
        const auto received = transport.receive(packet, 0.0);
        EXPECT_TRUE(received) << received.error().message;
        return received && *received ? packet : Octets{};
    }
};

TEST(UdpTransport, sendsCommandsAndTakesEveryMessageOfADatagram) {
    Pair pair;
    ASSERT_TRUE(pair.transport.open());
    ASSERT_TRUE(pair.transport.send(Octets{0xFF, 0x00}));
    pair.server.exchange(pair.board);
    EXPECT_EQ(pair.next(), (Octets{0xFF, 0xFF, 0x00}));
    ASSERT_TRUE(pair.transport.send(Octets{0xFD}));
    pair.board.say({0x00, 0x07});
    pair.server.exchange(pair.board);
    EXPECT_EQ(pair.next(), (Octets{0x00, 0x07}));
    EXPECT_EQ(pair.next(), (Octets{0xFF, 0xFD}));
    EXPECT_TRUE(pair.next().empty());
    EXPECT_EQ(pair.transport.statistics().packetsReceived, 3U);
    EXPECT_EQ(pair.transport.statistics().packetsLost, 0U);
}

TEST(UdpDevice, worksLikeTheEmbeddedBoard) {
    const BoardServer server(ServedLine::Udp);
    auto opened = openDevice(server.uri(), {});
    ASSERT_TRUE(opened) << opened.error().message;
    const auto device = *std::move(opened);
    EXPECT_EQ(device->info().model, "htm");
    EXPECT_EQ(device->info().transport, "udp");
    const ParameterValue gain{"gain.kp", 12.5};
    ASSERT_TRUE(device->writeParameters({&gain, 1}));
    EXPECT_DOUBLE_EQ((*device->readParameters({&gain.name, 1}))[0], 12.5);
    Recording recording;
    ASSERT_TRUE(device->startStream({{"position", "speed"}, 500.0},
                                    [&](const SampleBlockPtr& block) { recording.append(*block); }));
    ASSERT_TRUE(device->clock().waitFor(0.3));
    device->stopStream();
    ASSERT_GT(recording.rows(), 50U);
    EXPECT_EQ(recording.lostRows, 0U);
}

TEST(UdpDevice, nobodyAtThePortIsADeviceLostWithinTwoSeconds) {
    NetworkAddress address{"127.0.0.1", 0};
    { // a port that was free a moment ago
        ASSERT_TRUE(bindSocket(address, SocketKind::Datagram));
    }
    const auto device = openDevice("udp:" + address.text(), {});
    ASSERT_FALSE(device);
    EXPECT_EQ(device.error().code, ErrorCode::DeviceLost);
    EXPECT_NE(device.error().message.find("udp:" + address.text()), std::string::npos);
}

TEST(UdpDevice, secondMasterTakesTheSession) {
    const BoardServer server(ServedLine::Udp);
    const auto first = openDevice(server.uri(), {});
    ASSERT_TRUE(first);
    const auto second = openDevice(server.uri(), {});
    ASSERT_TRUE(second);
    const auto waited = (*first)->clock().waitFor(3.0);
    ASSERT_FALSE(waited) << "nobody answers the first any more";
    EXPECT_EQ(waited.error().code, ErrorCode::DeviceLost);
    EXPECT_TRUE((*second)->clock().waitFor(0.05));
}

} // namespace
} // namespace halbench::devices
