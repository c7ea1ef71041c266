#include "devices/transport/message_stream.h"
#include "devices/transport/udp_server.h"
#include "tests/devices/transport/echo_board.h"

#include <gtest/gtest.h>

#include <array>

namespace halbench::devices {
namespace {

const Octets Connect{0xFF, 0x00};
const Octets Status{0xFD};
const Octets Stop{0xF1, 0x45};

Octets datagramOf(std::initializer_list<Octets> packets) {
    Octets datagram;
    for (const Octets& packet : packets) {
        appendMessage(datagram, 0, packet);
    }
    return datagram;
}

/// One master: a socket of its own. Datagrams on one machine arrive before send() returns, so that nothing
/// here waits.
class UdpMaster {
public:
    explicit UdpMaster(const UdpServer& server) {
        const auto address = parseNetworkAddress(server.address().substr(4));
        const auto list = resolve(*address, SocketKind::Datagram, false);
        m_socket = makeSocket(**list);
        EXPECT_EQ(::connect(m_socket.number(), (*list)->ai_addr, (*list)->ai_addrlen), 0);
    }
    void send(const Octets& datagram) {
        EXPECT_EQ(::send(m_socket.number(), datagram.data(), datagram.size(), 0),
                  static_cast<ssize_t>(datagram.size()));
    }
    /// Octets of the next datagram; empty when none is there.
    Octets receive() {
        std::array<std::uint8_t, 65536> octets;
        const ssize_t count = ::recv(m_socket.number(), octets.data(), octets.size(), 0);
        return count <= 0 ? Octets{} : Octets(octets.begin(), octets.begin() + count);
    }

private:
    Descriptor m_socket;
};

UdpServer boundServer() {
    return *UdpServer::bind({"127.0.0.1", 0});
}

TEST(UdpServer, namesItsRealPort) {
    const UdpServer server = boundServer();
    EXPECT_EQ(server.address().substr(0, 14), "udp:127.0.0.1:");
    EXPECT_NE(server.address(), "udp:127.0.0.1:0");
}

TEST(UdpServer, portInUseIsRefusedWithTheAddress) {
    const UdpServer server = boundServer();
    const auto again = UdpServer::bind(*parseNetworkAddress(server.address().substr(4)));
    ASSERT_FALSE(again);
    EXPECT_EQ(again.error().code, ErrorCode::InvalidInput);
    EXPECT_NE(again.error().message.find(server.address()), std::string::npos);
}

TEST(UdpServer, answersEveryMessageOfADatagramInOne) {
    UdpServer server = boundServer();
    EchoBoard board;
    UdpMaster master(server);
    master.send(datagramOf({Connect, Status, Status}));
    server.exchange(board);
    EXPECT_EQ(board.received, (std::vector<Octets>{Connect, Status, Status}));
    // LEN u16, CTR u16, packet; one counter over all messages (resources/help/protocol.md 3.2)
    EXPECT_EQ(master.receive(), (Octets{3, 0, 0, 0, 0xFF, 0xFF, 0, //
                                        2, 0, 1, 0, 0xFF, 0xFD,    //
                                        2, 0, 2, 0, 0xFF, 0xFD}));
    EXPECT_TRUE(master.receive().empty());
}

TEST(UdpServer, noDatagramIsLongerThan512OctetsAndNoneIsCutShort) {
    UdpServer server = boundServer();
    EchoBoard board;
    UdpMaster master(server);
    master.send(datagramOf({Connect}));
    server.exchange(board);
    (void)master.receive();
    const std::array<std::size_t, 7> sizes = {508, 1, 300, 204, 300, 509, 3};
    for (const std::size_t size : sizes) {
        board.say(Octets(size, 0x11));
    }
    server.exchange(board);
    std::vector<std::size_t> packets;
    for (Octets datagram = master.receive(); !datagram.empty(); datagram = master.receive()) {
        EXPECT_LE(datagram.size(), UdpServer::MaxDatagram);
        MessageParser parser(65535);
        parser.feed(datagram);
        for (auto message = parser.next(); message && *message; message = parser.next()) {
            packets.push_back((*message)->packet.size());
        }
    }
    // 509 octets and their header do not fit: left out, its counter is a gap.
    EXPECT_EQ(packets, (std::vector<std::size_t>{508, 1, 300, 204, 300, 3}));
}

TEST(UdpServer, whatIsNotAWholeMessageIsDropped) {
    UdpServer server = boundServer();
    EchoBoard board;
    UdpMaster master(server);
    master.send(datagramOf({Connect}));
    const Octets whole = datagramOf({Status});
    for (std::size_t size = 0; size < whole.size(); ++size) {
        master.send(Octets(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)));
    }
    master.send(Octets(1400, 0xFF));
    master.send({0, 0, 0, 0});
    server.exchange(board);
    EXPECT_EQ(board.received, std::vector<Octets>{Connect});
    master.send(whole); // nothing of the broken ones is left
    server.exchange(board);
    EXPECT_EQ(board.received.size(), 2U);
}

const Octets Disconnect{0xFE};
const Octets Refused{2, 0, 0, 0, 0xFE, 0x33}; // ERR_RESOURCE_TEMPORARY_NOT_ACCESSIBLE

TEST(UdpServer, sessionBelongsToTheMasterThatConnectedFirst) {
    UdpServer server = boundServer();
    EchoBoard board;
    UdpMaster first(server);
    UdpMaster second(server);
    first.send(datagramOf({Connect}));
    server.exchange(board);
    EXPECT_FALSE(first.receive().empty());
    second.send(datagramOf({Status}));
    server.exchange(board);
    EXPECT_TRUE(second.receive().empty());
    second.send(datagramOf({Connect}));
    server.exchange(board);
    EXPECT_EQ(board.received.size(), 1U) << "a stranger's command is not heeded";
    EXPECT_EQ(second.receive(), Refused);
    board.say({0x00, 0x01});
    first.send(datagramOf({Disconnect}));
    server.exchange(board);
    EXPECT_EQ(first.receive(), (Octets{2, 0, 1, 0, 0x00, 0x01, 2, 0, 2, 0, 0xFF, 0xFE}));
    second.send(datagramOf({Connect}));
    server.exchange(board);
    EXPECT_EQ(second.receive(), (Octets{3, 0, 3, 0, 0xFF, 0xFF, 0x00}));
    first.send(datagramOf({Status}));
    server.exchange(board);
    EXPECT_EQ(board.received.size(), 3U);
    EXPECT_TRUE(first.receive().empty());
}

TEST(UdpServer, silentMasterLosesItToTheNextThatAsks) {
    UdpServer server = boundServer();
    EchoBoard board;
    UdpMaster first(server);
    UdpMaster second(server);
    first.send(datagramOf({Connect}));
    server.exchange(board);
    server.advanceTo(SessionHolder::Timeout_s + 0.1);
    second.send(datagramOf({Connect}));
    server.exchange(board);
    EXPECT_EQ(second.receive(), (Octets{3, 0, 1, 0, 0xFF, 0xFF, 0x00}));
}

TEST(UdpServer, obeysTheStopOfAnybodyAndAnswersOnlyTheMaster) {
    UdpServer server = boundServer();
    EchoBoard board;
    UdpMaster stranger(server);
    stranger.send(datagramOf({Stop}));
    server.exchange(board);
    EXPECT_EQ(board.received, std::vector<Octets>{Stop});
    EXPECT_TRUE(stranger.receive().empty());
    EXPECT_TRUE(board.hasSaidEverything()) << "what is said while nobody listens is not kept for later";
    UdpMaster master(server);
    master.send(datagramOf({Connect}));
    server.exchange(board);
    (void)master.receive();
    stranger.send(datagramOf({Stop}));
    server.exchange(board);
    EXPECT_EQ(board.received.size(), 3U);
    EXPECT_TRUE(master.receive().empty()) << "it would pass for the answer to the master's own command";
}

/// What a network may do to the datagrams of a master (resources/help/protocol.md 3.2).
TEST(UdpServer, doesNothingTwiceAndNothingLate) {
    UdpServer server = boundServer();
    EchoBoard board;
    UdpMaster master(server);
    const auto numbered = [](std::uint16_t counter, const Octets& packet) {
        Octets datagram;
        appendMessage(datagram, counter, packet);
        return datagram;
    };
    const Octets start = numbered(0xFFFE, Connect);
    const Octets one = numbered(0xFFFF, {0xF0, 0x01, 0x01});
    const Octets two = numbered(0, {0xF0, 0x01, 0x02});
    const Octets three = numbered(1, {0xF0, 0x01, 0x03});
    for (const Octets& datagram : {start, start, one, one, three, two, three, one, start}) {
        master.send(datagram);
    }
    server.exchange(board);
    EXPECT_EQ(board.received, (std::vector<Octets>{Connect, {0xF0, 0x01, 0x01}, {0xF0, 0x01, 0x03}}))
        << "repeats are dropped, and so is the command that was overtaken";
    server.advanceTo(1.0);
    master.send(start); // started again at the same address, it counts anew
    master.send(one);
    server.exchange(board);
    EXPECT_EQ(board.received.size(), 5U);
}

TEST(UdpServer, aStopThatWasOvertakenOrComesTwiceStopsAndIsNotAnswered) {
    UdpServer server = boundServer();
    EchoBoard board;
    UdpMaster master(server);
    const auto send = [&](std::uint16_t counter, const Octets& packet) {
        Octets datagram;
        appendMessage(datagram, counter, packet);
        master.send(datagram);
        server.exchange(board);
    };
    send(10, Connect);
    send(12, Status); // overtakes the stop
    while (!master.receive().empty()) {
    }
    send(11, Stop);
    EXPECT_EQ(board.received, (std::vector<Octets>{Connect, Status, Stop}));
    EXPECT_TRUE(master.receive().empty()) << "it would pass for the answer to the command after it";
    send(13, Stop);
    EXPECT_FALSE(master.receive().empty()) << "in its turn it is answered";
    send(13, Stop);
    EXPECT_EQ(board.received.size(), 5U);
    EXPECT_TRUE(master.receive().empty());
}

TEST(UdpServer, waitsNoLongerThanTold) {
    UdpServer server = boundServer();
    server.waitForTraffic(0);
    UdpMaster master(server);
    master.send(datagramOf({Connect}));
    server.waitForTraffic(60000); // returns at once: something is there
}

} // namespace
} // namespace halbench::devices
