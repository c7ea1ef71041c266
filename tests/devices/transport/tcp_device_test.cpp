#include "devices/open/open_device.h"
#include "devices/transport/tcp_socket.h"
#include "devices/transport/tcp_transport.h"
#include "tests/devices/transport/served_board.h"

#include <gtest/gtest.h>
#include <sys/socket.h>

#include <array>
#include <cstring>
#include <thread>

namespace halbench::devices {
namespace {

std::unique_ptr<Device> open(const BoardServer& server) {
    Result<std::unique_ptr<Device>> device = openDevice(server.uri(), {});
    if (!device) {
        ADD_FAILURE() << device.error().message;
        return nullptr;
    }
    return *std::move(device);
}

TEST(TcpDevice, worksLikeTheEmbeddedBoard) {
    const BoardServer server;
    const auto device = open(server);
    ASSERT_TRUE(device);
    EXPECT_EQ(device->info().model, "htm");
    EXPECT_FALSE(device->info().isSimulated) << "what is behind a line may move: it needs consent";
    const ParameterValue gain{"gain.kp", 12.5};
    ASSERT_TRUE(device->writeParameters({&gain, 1}));
    EXPECT_DOUBLE_EQ((*device->readParameters({&gain.name, 1}))[0], 12.5);
    Recording recording;
    ASSERT_TRUE(device->startStream({{"position", "speed"}, 500.0},
                                    [&](const SampleBlockPtr& block) { recording.append(*block); }));
    ASSERT_TRUE(device->clock().waitFor(0.3));
    device->stopStream();
    EXPECT_EQ(recording.lostRows, 0U);
    EXPECT_EQ(device->statistics().packetsLost, 0U);
    ASSERT_GT(recording.rows(), 50U);
    for (std::size_t row = 0; row < recording.rows(); ++row) {
        EXPECT_DOUBLE_EQ(recording.time_s[row], static_cast<double>(row) / 500.0);
    }
}

TEST(TcpDevice, bareConnectionsDoNotStopTheMasterThatMovesTheMotor) {
    const BoardServer server;
    const auto device = open(server);
    ASSERT_TRUE(device);
    ASSERT_TRUE(device->arm());
    for (int i = 0; i < 5; ++i) { // a port scan, a health check
        const auto bare = connectTcp(*parseNetworkAddress(server.uri().substr(4)), 1.0);
        ASSERT_TRUE(bare);
        ASSERT_TRUE(device->clock().waitFor(0.02));
    }
    EXPECT_TRUE(device->state().isArmed);
    EXPECT_EQ(device->statistics().packetsLost, 0U);
}

TEST(TcpDevice, secondMasterIsRefusedWithTheReasonAndTheFirstWorksOn) {
    const BoardServer server;
    const auto first = open(server);
    ASSERT_TRUE(first);
    const auto second = openDevice(server.uri(), {});
    ASSERT_FALSE(second);
    EXPECT_EQ(second.error().code, ErrorCode::DeviceRefused);
    EXPECT_NE(second.error().message.find("another program"), std::string::npos) << second.error().message;
    EXPECT_FALSE(second.error().hint.empty());
    EXPECT_TRUE(first->clock().waitFor(0.05));
    EXPECT_TRUE(first->state().isConnected);
}

TEST(TcpDevice, boardIsFreeOnceTheFirstMasterHasLeft) {
    const BoardServer server;
    auto first = open(server);
    ASSERT_TRUE(first);
    EXPECT_TRUE(first->clock().waitFor(0.05));
    first.reset();
    EXPECT_TRUE(open(server));
}

/// A tool that says nothing for longer than we do would lose its session to a watchdog that we left.
TEST(TcpDevice, watchdogIsAsItWasHoweverTheArmedBoardWasLeft) {
    const std::string name = "hb.watchdog_ms";
    const BoardServer server;
    for (int end = 0; end < 4; ++end) {
        auto device = open(server);
        ASSERT_TRUE(device);
        ASSERT_TRUE(device->arm());
        if (end == 1) {
            ASSERT_TRUE(device->disarm());
        } else if (end > 1) {
            device->stop();
        }
        if (end == 3) {
            ASSERT_TRUE(device->clearStop());
        }
        device.reset();
        const auto next = open(server);
        ASSERT_TRUE(next);
        EXPECT_EQ(next->readParameters({&name, 1})->front(), 0.0) << end;
        ASSERT_TRUE(next->clearStop());
    }
}

TEST(TcpDevice, serverThatDiesIsADeviceLost) {
    BoardServer server;
    const auto device = open(server);
    ASSERT_TRUE(device);
    ASSERT_TRUE(device->startStream({{"position"}, 100.0}, [](const SampleBlockPtr&) {}));
    server.end();
    const auto waited = device->clock().waitFor(5.0);
    ASSERT_FALSE(waited);
    EXPECT_EQ(waited.error().code, ErrorCode::DeviceLost);
    EXPECT_LT(device->clock().now_s(), 2.5) << "nobody waits longer than 2 s for a dead board";
    device->stop();
    device->stopStream();
}

TEST(TcpDevice, nothingListeningIsADeviceLostWithTheAddress) {
    NetworkAddress address{"127.0.0.1", 0};
    { // a port that was free a moment ago
        const auto listener = bindSocket(address, SocketKind::Stream);
        ASSERT_TRUE(listener);
    }
    const auto device = openDevice("tcp:" + address.text(), {});
    ASSERT_FALSE(device);
    EXPECT_EQ(device.error().code, ErrorCode::DeviceLost);
    EXPECT_NE(device.error().message.find(address.text()), std::string::npos);
}

TEST(TcpDevice, serverDisconnectsAMasterThatSendsNonsenseAndServesTheNext) {
    const BoardServer server;
    const auto address = parseNetworkAddress(server.uri().substr(4));
    ASSERT_TRUE(address);
    TcpTransport nonsense(*address);
    ASSERT_TRUE(nonsense.open());
    const std::vector<std::uint8_t> tooLong(1000, 0xFF);
    ASSERT_TRUE(nonsense.send(tooLong));
    std::vector<std::uint8_t> packet;
    const auto received = nonsense.receive(packet, 2.0);
    ASSERT_FALSE(received);
    EXPECT_EQ(received.error().code, ErrorCode::DeviceLost);
    EXPECT_TRUE(open(server));
}

TEST(TcpDevice, sendsAStopWhileStreamingAndSeesTheLatch) {
    const BoardServer server;
    const auto device = open(server);
    ASSERT_TRUE(device);
    ASSERT_TRUE(device->startStream({{"position"}, 1000.0}, [](const SampleBlockPtr&) {}));
    ASSERT_TRUE(device->arm());
    ASSERT_TRUE(device->clock().waitFor(0.05));
    device->stop();
    EXPECT_TRUE(device->state().isStopLatched);
}

/// Something else listens at the port: it talks first, or it answers and hangs up.
TEST(TcpDevice, anotherProtocolIsCalledSo) {
    for (const bool hangsUp : {false, true}) {
        for (const char* greeting : {"SSH-2.0-OpenSSH_9.2p1\r\n", "HTTP/1.1 400 Bad Request\r\n\r\n"}) {
            NetworkAddress address{"127.0.0.1", 0};
            const auto listener = bindSocket(address, SocketKind::Stream);
            ASSERT_TRUE(listener);
            std::thread stranger([&] {
                ASSERT_TRUE(listener->isReadableWithin(2.0));
                Descriptor client = acceptTcp(*listener);
                ASSERT_TRUE(client.isReadableWithin(2.0));
                std::array<char, 64> command{};
                (void)::recv(client.number(), command.data(), command.size(),
                             0); // unread, it would be a reset
                (void)::send(client.number(), greeting, std::strlen(greeting), MSG_NOSIGNAL);
                while (!hangsUp && ::recv(client.number(), command.data(), command.size(), 0) != 0) {
                    (void)client.isReadableWithin(3.0); // until the program gives up
                }
            });
            const auto device = openDevice("tcp:" + address.text(), {});
            stranger.join();
            ASSERT_FALSE(device);
            EXPECT_EQ(device.error().code, ErrorCode::Protocol) << device.error().message;
            EXPECT_NE(device.error().message.find("protocol"), std::string::npos) << device.error().message;
            EXPECT_NE(device.error().hint.find("address"), std::string::npos) << device.error().hint;
        }
    }
}

} // namespace
} // namespace halbench::devices
