#include "devices/transport/tcp_server.h"
#include "devices/transport/tcp_transport.h"
#include "tests/devices/transport/echo_board.h"

#include <gtest/gtest.h>
#include <sys/socket.h>

#include <array>

namespace halbench::devices {
namespace {

const Octets Connect{0xFF, 0x00};
const Octets Status{0xFD};
const Octets Stop{0xF1, 0x45};
const Octets Refused{0xFE, 0x33}; // ERR_RESOURCE_TEMPORARY_NOT_ACCESSIBLE

/// A port with a board, driven by the test; connections on one machine need no waiting.
struct Port {
    TcpServer server = *TcpServer::listen({"127.0.0.1", 0});
    EchoBoard board;
    void exchange() { server.exchange(board); }
};

class Caller {
public:
    explicit Caller(Port& port) : m_port(&port) {
        m_socket = *connectTcp(*parseNetworkAddress(port.server.address().substr(4)), 1.0);
        port.exchange();
    }
    void send(const Octets& packet) {
        Octets octets;
        appendMessage(octets, m_counter++, packet);
        EXPECT_EQ(::send(m_socket.number(), octets.data(), octets.size(), MSG_NOSIGNAL),
                  static_cast<ssize_t>(octets.size()));
        m_port->exchange();
    }
    /// Packets that have arrived.
    std::vector<Octets> heard() {
        std::array<std::uint8_t, 4096> octets;
        const ssize_t count = ::recv(m_socket.number(), octets.data(), octets.size(), 0);
        m_isClosed = m_isClosed || count == 0;
        m_parser.feed({octets.data(), count > 0 ? static_cast<std::size_t>(count) : 0});
        std::vector<Octets> packets;
        for (auto message = m_parser.next(); message && *message; message = m_parser.next()) {
            packets.emplace_back((*message)->packet.begin(), (*message)->packet.end());
        }
        return packets;
    }
    bool isClosed() {
        while (!heard().empty()) { // the end comes behind what was said before
        }
        return m_isClosed;
    }
    void leave() {
        m_socket.close();
        m_port->exchange();
    }

private:
    Port* m_port;
    Descriptor m_socket;
    MessageParser m_parser{65535};
    std::uint16_t m_counter = 0;
    bool m_isClosed = false;
};

Octets echoed(const Octets& packet) {
    Octets answer{0xFF};
    answer.insert(answer.end(), packet.begin(), packet.end());
    return answer;
}

TEST(TcpServer, connectionsThatSayNothingAreNoSession) {
    Port port;
    Caller early(port);
    Caller master(port);
    master.send(Connect);
    EXPECT_EQ(master.heard(), std::vector<Octets>{echoed(Connect)})
        << "one that only connected holds nothing";
    { Caller scan(port); } // a port scan, a health check
    Caller silent(port);
    Caller nonsense(port);
    nonsense.send(Octets(300, 0xFF));
    master.send(Status);
    EXPECT_EQ(master.heard(), std::vector<Octets>{echoed(Status)});
    EXPECT_TRUE(nonsense.isClosed());
    EXPECT_FALSE(master.isClosed());
}

TEST(TcpServer, secondMasterIsRefusedWithTheReasonAndTheFirstWorksOn) {
    Port port;
    Caller first(port);
    Caller second(port);
    first.send(Connect);
    second.send(Connect);
    second.send(Status);
    EXPECT_EQ(second.heard(), std::vector<Octets>{Refused}) << "and what is no CONNECT is not answered";
    port.board.say({0x00, 0x01});
    first.send(Status);
    EXPECT_EQ(first.heard(), (std::vector<Octets>{echoed(Connect), {0x00, 0x01}, echoed(Status)}));
    EXPECT_EQ(port.board.received, (std::vector<Octets>{Connect, Status}));
    first.leave();
    second.send(Connect);
    EXPECT_EQ(second.heard(), std::vector<Octets>{echoed(Connect)}) << "the same connection may ask again";
}

TEST(TcpServer, silentMasterIsToldThatAnotherHasTheBoard) {
    Port port;
    Caller first(port);
    Caller second(port);
    port.server.advanceTo(10.0);
    first.send(Connect);
    port.server.advanceTo(10.0 + SessionHolder::Timeout_s);
    second.send(Connect);
    EXPECT_EQ(second.heard(), std::vector<Octets>{Refused});
    port.server.advanceTo(10.1 + SessionHolder::Timeout_s);
    second.send(Connect);
    EXPECT_EQ(second.heard(), std::vector<Octets>{echoed(Connect)});
    EXPECT_TRUE(first.isClosed());
}

TEST(TcpServer, stopOfAStrangerIsObeyedAndItsAnswerIsNobodys) {
    Port port;
    Caller master(port);
    Caller stranger(port);
    master.send(Connect);
    (void)master.heard();
    stranger.send(Stop);
    EXPECT_EQ(port.board.received, (std::vector<Octets>{Connect, Stop}));
    EXPECT_TRUE(stranger.heard().empty());
    EXPECT_TRUE(master.heard().empty()) << "it would pass for the answer to the master's own command";
}

TEST(TcpServer, connectionsThatStayOpenDoNotPileUpAndCostTheMasterNothing) {
    Port port;
    Caller master(port);
    master.send(Connect);
    std::vector<std::unique_ptr<Caller>> idle;
    for (std::size_t i = 0; i < TcpServer::MaxCallers; ++i) {
        idle.push_back(std::make_unique<Caller>(port));
    }
    EXPECT_TRUE(idle.front()->isClosed());
    EXPECT_FALSE(idle.back()->isClosed());
    master.send(Status);
    EXPECT_EQ(master.heard(), (std::vector<Octets>{echoed(Connect), echoed(Status)}));
}

TEST(TcpServer, rowsOfASlowMasterAreNotTheNextOnes) {
    Port port;
    Caller slow(port);
    Caller next(port);
    slow.send(Connect);
    // It reads nothing: beyond what the socket and the server keep for it the rows wait in the board.
    const Octets row(1000, 0x11);
    do {
        port.board.say(row);
        port.exchange();
    } while (port.board.hasSaidEverything());
    port.board.say({0xFD, 0x07}); // its session is over
    port.server.advanceTo(SessionHolder::Timeout_s + 0.1);
    next.send(Connect);
    EXPECT_EQ(next.heard(), std::vector<Octets>{echoed(Connect)});
    next.send(Status);
    EXPECT_EQ(next.heard(), std::vector<Octets>{echoed(Status)}) << "the end of the other session is not its";
}

TEST(TcpServer, saysWhetherOtherMachinesReachIt) {
    EXPECT_FALSE(TcpServer::listen({"127.0.0.1", 0})->isOpenToNetwork());
    EXPECT_FALSE(TcpServer::listen({"localhost", 0})->isOpenToNetwork());
    EXPECT_FALSE(TcpServer::listen({"127.1.2.3", 0})->isOpenToNetwork()) << "all of 127 is this machine";
    EXPECT_TRUE(TcpServer::listen({"0.0.0.0", 0})->isOpenToNetwork());
}

// A server refuses a second master in its own name, with a counter that is not the board's: the step to the
// board's first answer is no loss, the one behind it is.
TEST(TcpTransport, countsWhatIsLostFromTheFirstAnswerOfTheBoardOn) {
    for (const int refusals : {0, 1, 3}) {
        for (const int first : {0, 3470, 65534}) {
            NetworkAddress address{"127.0.0.1", 0};
            const auto listener = bindSocket(address, SocketKind::Stream);
            ASSERT_TRUE(listener);
            TcpTransport transport(address);
            ASSERT_TRUE(transport.open());
            const Descriptor board = acceptTcp(*listener);
            ASSERT_TRUE(board.isOpen());
            Octets octets;
            for (int i = 0; i < refusals; ++i) {
                appendMessage(octets, static_cast<std::uint16_t>(i), Refused);
            }
            for (const int step : {0, 1, 4}) { // two are missing before the last one
                appendMessage(octets, static_cast<std::uint16_t>(first + step), Connect);
            }
            ASSERT_EQ(::send(board.number(), octets.data(), octets.size(), MSG_NOSIGNAL),
                      static_cast<ssize_t>(octets.size()));
            Octets packet;
            for (int i = 0; i < refusals + 3; ++i) {
                ASSERT_TRUE(transport.receive(packet, 1.0).value_or(false));
            }
            EXPECT_EQ(transport.statistics().packetsLost, 2U) << refusals << ' ' << first;
        }
    }
}

} // namespace
} // namespace halbench::devices
