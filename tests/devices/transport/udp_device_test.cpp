#include "control/base/random.h"
#include "devices/open/open_device.h"
#include "tests/devices/transport/served_board.h"
#include "tests/devices/transport/udp_pair.h"

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <functional>

namespace halbench::devices {
namespace {

const Octets Connect{0xFF, 0x00};

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

TEST(UdpDevice, secondMasterIsRefusedAndTheFirstWorksOn) {
    const BoardServer server(ServedLine::Udp);
    auto first = openDevice(server.uri(), {});
    ASSERT_TRUE(first);
    const auto second = openDevice(server.uri(), {});
    ASSERT_FALSE(second);
    EXPECT_NE(second.error().message.find("another program"), std::string::npos) << second.error().message;
    EXPECT_TRUE((*first)->clock().waitFor(0.05));
    first->reset();
    EXPECT_TRUE(openDevice(server.uri(), {})) << "it said that it goes";
}

/// A network between a program and a board that delivers datagrams twice and late.
class UnrulyNetwork {
public:
    UnrulyNetwork(const UdpServer& board, std::uint64_t seed) : m_random(seed) {
        const auto list =
            resolve(*parseNetworkAddress(board.address().substr(4)), SocketKind::Datagram, false);
        m_board = makeSocket(**list);
        EXPECT_EQ(::connect(m_board.number(), (*list)->ai_addr, (*list)->ai_addrlen), 0);
        m_program = *bindSocket(address, SocketKind::Datagram);
    }
    /// What the program sent, to the board.
    void toBoard() {
        for (Octets datagram = taken(m_program, &m_peer); !datagram.empty();
             datagram = taken(m_program, &m_peer)) {
            for (const Octets& octets : passed(datagram, m_lateToBoard)) {
                (void)::send(m_board.number(), octets.data(), octets.size(), MSG_NOSIGNAL);
            }
        }
    }
    /// What the board sent, to the program.
    void toProgram() {
        for (Octets datagram = taken(m_board, nullptr); !datagram.empty();
             datagram = taken(m_board, nullptr)) {
            for (const Octets& octets : passed(datagram, m_lateToProgram)) {
                (void)::sendto(m_program.number(), octets.data(), octets.size(), MSG_NOSIGNAL,
                               reinterpret_cast<const sockaddr*>(&m_peer), sizeof(sockaddr_in));
            }
        }
    }

    NetworkAddress address{"127.0.0.1", 0};

private:
    static Octets taken(const Descriptor& socket, sockaddr_storage* sender) {
        Octets datagram(65536);
        socklen_t size = sizeof(sockaddr_storage);
        const ssize_t count =
            ::recvfrom(socket.number(), datagram.data(), datagram.size(), 0,
                       reinterpret_cast<sockaddr*>(sender), sender == nullptr ? nullptr : &size);
        datagram.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
        return datagram;
    }
    /// One in twenty comes twice, one in twenty behind the next one.
    std::vector<Octets> passed(const Octets& datagram, Octets& late) {
        const double draw = m_random.uniform();
        const bool isLate = draw < 0.05;
        std::vector<Octets> all(isLate ? 0 : draw > 0.95 ? 2 : 1, datagram);
        if (!late.empty()) {
            all.push_back(late);
        }
        late = isLate ? datagram : Octets();
        return all;
    }

    Random m_random;
    Descriptor m_board;
    Descriptor m_program;
    sockaddr_storage m_peer{};
    Octets m_lateToBoard;
    Octets m_lateToProgram;
};

/// Without the counter every repeat would be an answer too many, and from then on each value stand under the
/// name before it.
TEST(UdpTransport, noAnswerOfAnUnrulyNetworkComesTwiceOrLate) {
    for (const std::uint64_t seed : {1, 2, 3}) {
        UdpServer server = *UdpServer::bind({"127.0.0.1", 0});
        EchoBoard board;
        UnrulyNetwork network(server, seed);
        UdpTransport transport(network.address);
        ASSERT_TRUE(transport.open());
        Octets last;
        std::uint16_t number = 0;
        const auto exchange = [&](const Octets& command) {
            ASSERT_TRUE(transport.send(command));
            network.toBoard();
            server.exchange(board);
            network.toProgram();
            Octets answer;
            while (*transport.receive(answer, 0.0)) {
                EXPECT_LT(last, answer) << "numbers are big endian: each is larger than the one before";
                last = answer;
            }
        };
        const auto command = [](std::uint16_t value) {
            return Octets{0xF4, static_cast<std::uint8_t>(value >> 8), static_cast<std::uint8_t>(value)};
        };
        for (int tries = 0; last.empty() && tries < 10; ++tries) {
            exchange(Connect);
        }
        last.clear();
        board.received.clear();
        const std::uint64_t before = transport.statistics().packetsReceived;
        while (number < 2000 || last != Octets({0xFF, 0xF4, static_cast<std::uint8_t>(number >> 8),
                                                static_cast<std::uint8_t>(number)})) {
            exchange(command(++number));
        }
        EXPECT_TRUE(std::is_sorted(board.received.begin(), board.received.end(), std::less_equal<>()))
            << "no command was done twice or late";
        const TransportStatistics seen = transport.statistics();
        EXPECT_EQ(seen.packetsReceived - before + seen.packetsLost, board.received.size())
            << "what is missing is counted";
        EXPECT_GT(seen.packetsReceived - before, 1600U) << "one in ten is held up, each way";
    }
}

} // namespace
} // namespace halbench::devices
