#include "devices/open/sxi_framing.h"
#include "devices/transport/pty_server.h"
#include "tests/devices/transport/echo_board.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <termios.h>
#include <unistd.h>

#include <array>

namespace halbench::devices {
namespace {

// resources/help/protocol.md 3.3.3
const Octets ConnectFrame{0x9A, 0x02, 0x00, 0xFF, 0x00, 0x01, 0x01};
const Octets StatusFrame{0x9A, 0x01, 0x01, 0xFD, 0x00, 0xFE, 0x01};

/// A program that opens the terminal like a serial port and changes none of its settings.
class SerialMaster {
public:
    explicit SerialMaster(const PtyServer& server)
        : m_line(::open(server.address().substr(4).c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK)) {
        EXPECT_TRUE(m_line.isOpen());
    }
    void send(const Octets& octets) {
        EXPECT_EQ(::write(m_line.number(), octets.data(), octets.size()),
                  static_cast<ssize_t>(octets.size()));
        EXPECT_EQ(::tcdrain(m_line.number()), 0);
    }
    /// The packets that arrived, as the framing understands them.
    std::vector<Octets> receive() {
        std::array<std::uint8_t, 8192> octets;
        std::vector<Octets> packets;
        for (ssize_t count; (count = ::read(m_line.number(), octets.data(), octets.size())) > 0;) {
            for (ssize_t i = 0; i < count; ++i) {
                const auto packet = m_framing.receive(octets[static_cast<std::size_t>(i)]);
                if (!packet.empty()) {
                    packets.emplace_back(packet.begin(), packet.end());
                }
            }
        }
        return packets;
    }

private:
    Descriptor m_line;
    SxiFraming m_framing;
};

PtyServer openServer() {
    auto server = PtyServer::open(std::make_unique<SxiFraming>());
    EXPECT_TRUE(server) << server.error().message;
    return *std::move(server);
}

/// Octets pass the terminal's buffer in the kernel's own time: the server is given up to a second to see
/// them.
void exchangeUntil(PtyServer& server, EchoBoard& board, std::size_t packets) {
    for (int i = 0; i < 1000 && board.received.size() < packets; ++i) {
        server.waitForTraffic(1);
        server.exchange(board);
    }
}

std::vector<Octets> receiveSome(PtyServer& server, EchoBoard& board, SerialMaster& master) {
    std::vector<Octets> packets;
    for (int i = 0; i < 1000 && packets.empty(); ++i) {
        server.waitForTraffic(1);
        server.exchange(board);
        packets = master.receive();
    }
    return packets;
}

TEST(PtyServer, answersFramesOnARawLine) {
    PtyServer server = openServer();
    EXPECT_EQ(server.address().substr(0, 5), "pty:/");
    EchoBoard board;
    SerialMaster master(server);
    master.send(ConnectFrame);
    master.send(StatusFrame);
    exchangeUntil(server, board, 2);
    EXPECT_EQ(board.received, (std::vector<Octets>{{0xFF, 0x00}, {0xFD}}));
    // Control characters and line ends of a terminal that is not raw: 03, 04, 0A, 0D, 11, 13, 1A, 7F
    board.say({0xFF, 0x03, 0x04, 0x0A, 0x0D, 0x11, 0x13, 0x1A, 0x7F, 0x9A, 0x9B});
    std::vector<Octets> packets;
    while (packets.size() < 3) {
        const std::vector<Octets> more = receiveSome(server, board, master);
        ASSERT_FALSE(more.empty());
        packets.insert(packets.end(), more.begin(), more.end());
    }
    EXPECT_EQ(packets,
              (std::vector<Octets>{{0xFF, 0xFF, 0x00},
                                   {0xFF, 0xFD},
                                   {0xFF, 0x03, 0x04, 0x0A, 0x0D, 0x11, 0x13, 0x1A, 0x7F, 0x9A, 0x9B}}));
}

TEST(PtyServer, survivesMastersThatCloseAndOpenAgain) {
    PtyServer server = openServer();
    EchoBoard board;
    for (std::size_t turn = 1; turn <= 3; ++turn) {
        SerialMaster master(server);
        master.send(ConnectFrame);
        EXPECT_EQ(receiveSome(server, board, master), (std::vector<Octets>{{0xFF, 0xFF, 0x00}}));
        EXPECT_EQ(board.received.size(), turn);
    }
}

TEST(PtyServer, connectDiscardsWhatAnEarlierMasterLeftUnread) {
    PtyServer server = openServer();
    EchoBoard board;
    {
        SerialMaster first(server);
        first.send(ConnectFrame);
        exchangeUntil(server, board, 1);
        for (int i = 0; i < 1000; ++i) { // far more than the line holds
            board.say(Octets(60, 0x01));
            server.exchange(board);
        }
        EXPECT_FALSE(board.hasSaidEverything()) << "a line that nobody reads holds device limit queue up";
    }
    SerialMaster second(server);
    second.send(ConnectFrame);
    exchangeUntil(server, board, 2);
    EXPECT_EQ(receiveSome(server, board, second), (std::vector<Octets>{{0xFF, 0xFF, 0x00}}));
}

TEST(SxiFraming, leavesOutAPacketThatIsTooLongForItsLength) {
    SxiFraming framing;
    Octets line;
    framing.append(line, 0, Octets(256, 0x01));
    framing.append(line, 0, Octets{});
    EXPECT_TRUE(line.empty());
    framing.append(line, 0, Octets{0xFF, 0x00});
    EXPECT_EQ(line, ConnectFrame);
}

TEST(SxiFraming, damagedFrameIsDroppedAndTheNextIsRead) {
    for (std::size_t at = 0; at < ConnectFrame.size(); ++at) {
        for (int kind = 0; kind < 3; ++kind) {
            Octets line = ConnectFrame;
            const auto place = line.begin() + static_cast<std::ptrdiff_t>(at);
            if (kind == 0) {
                *place ^= 0x20;
            } else if (kind == 1) {
                line.erase(place);
            } else {
                line.insert(place, 0x55);
            }
            line.insert(line.end(), StatusFrame.begin(), StatusFrame.end());
            SxiFraming framing;
            std::vector<Octets> packets;
            for (const std::uint8_t octet : line) {
                const auto packet = framing.receive(octet);
                if (!packet.empty()) {
                    packets.emplace_back(packet.begin(), packet.end());
                }
            }
            ASSERT_FALSE(packets.empty());
            EXPECT_EQ(packets.back(), Octets{0xFD}) << "octet " << at << ", damage " << kind;
            EXPECT_LE(packets.size(), 2U);
        }
    }
}

} // namespace
} // namespace halbench::devices
