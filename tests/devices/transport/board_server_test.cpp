#include "devices/transport/board_server.h"
#include "devices/transport/descriptor.h"
#include "devices/transport/network_address.h"
#include "tests/devices/transport/echo_board.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>

#include <algorithm>
#include <csignal>

namespace halbench::devices {
namespace {

/// Raises the flag after some exchanges.
class CountingPort : public ServerPort {
public:
    CountingPort(std::atomic<int>& flag, int exchanges) : m_flag(&flag), m_left(exchanges) {}
    std::string address() const override { return "test"; }
    void waitForTraffic(int timeout_ms) const override { EXPECT_LE(timeout_ms, 10); }
    void exchange(ServedBoard& board) override {
        times_s.push_back(static_cast<EchoBoard&>(board).time_s());
        if (--m_left == 0) {
            m_flag->store(SIGTERM);
        }
    }
    std::vector<double> times_s;

private:
    std::atomic<int>* m_flag;
    int m_left;
};

TEST(BoardServer, servesUntilTheFlagIsSetAndTimeNeverStepsBack) {
    std::atomic<int> flag{0};
    CountingPort port(flag, 100);
    EchoBoard board;
    serveBoard(port, board, flag);
    ASSERT_EQ(port.times_s.size(), 100U);
    EXPECT_TRUE(std::is_sorted(port.times_s.begin(), port.times_s.end()));
    EXPECT_GE(port.times_s.front(), 0.0);
}

/// Waits longer than the board's queue holds, as a process does that was stopped.
class SleepyPort : public CountingPort {
public:
    using CountingPort::CountingPort;
    void waitForTraffic(int) const override { (void)::poll(nullptr, 0, 80); }
};

// What the board sends in the time that it makes good must be taken before its queue is full.
TEST(BoardServer, takesWhatTheBoardSendsInSmallPiecesAfterAPause) {
    std::atomic<int> flag{0};
    SleepyPort port(flag, 20);
    EchoBoard board;
    serveBoard(port, board, flag);
    ASSERT_EQ(port.times_s.size(), 20U);
    EXPECT_GE(port.times_s.back(), 0.1) << "the pause is made good";
    for (std::size_t i = 1; i < port.times_s.size(); ++i) {
        EXPECT_LE(port.times_s[i] - port.times_s[i - 1], 0.0101);
    }
}

TEST(BoardServer, servesNothingOnceTheFlagIsSet) {
    std::atomic<int> flag{SIGINT};
    CountingPort port(flag, 1);
    EchoBoard board;
    serveBoard(port, board, flag);
    EXPECT_TRUE(port.times_s.empty());
}

TEST(Descriptor, closesWhatItOwnsOnceAndPassesItOn) {
    Descriptor first(::open("/dev/null", O_RDONLY));
    const int number = first.number();
    ASSERT_TRUE(first.isOpen());
    Descriptor second(std::move(first));
    EXPECT_EQ(second.number(), number);
    Descriptor third;
    third = std::move(second);
    EXPECT_NE(::fcntl(number, F_GETFD), -1);
    third.close();
    EXPECT_FALSE(third.isOpen());
    EXPECT_EQ(::fcntl(number, F_GETFD), -1);
}

TEST(NetworkAddress, takesHostAndPortAndRefusesTheRest) {
    EXPECT_EQ(parseNetworkAddress("127.0.0.1:5555")->port, 5555);
    EXPECT_EQ(parseNetworkAddress("[::1]:5555")->host, "::1");
    EXPECT_EQ(parseNetworkAddress("[::1]:5555")->text(), "[::1]:5555");
    for (const char* wrong : {"", "localhost", ":5555", "localhost:", "localhost:65536", "localhost:-1",
                              "localhost:5x", "::1:5555"}) {
        EXPECT_FALSE(parseNetworkAddress(wrong)) << wrong;
    }
}

TEST(NetworkAddress, aPlaceToListenAtIsThisMachineUnlessAHostIsNamed) {
    for (const char* text : {"5555", ":5555", "127.0.0.1:5555"}) {
        const auto address = parseListenAddress(text);
        ASSERT_TRUE(address) << text;
        EXPECT_EQ(address->text(), "127.0.0.1:5555") << text;
    }
    EXPECT_EQ(parseListenAddress("0.0.0.0:5555")->host, "0.0.0.0");
    EXPECT_EQ(parseListenAddress("[::1]:5555")->host, "::1");
    for (const char* wrong : {"", ":", "x", "65536", ":65536", "127.0.0.1", "127.0.0.1:x", "::1:5555"}) {
        EXPECT_FALSE(parseListenAddress(wrong)) << wrong;
    }
}

TEST(NetworkAddress, hostThatDoesNotExistIsNamedWithItsScheme) {
    for (const SocketKind kind : {SocketKind::Stream, SocketKind::Datagram}) {
        const auto list = resolve({"no.such.host.invalid", 1}, kind, false);
        ASSERT_FALSE(list);
        EXPECT_EQ(list.error().code, ErrorCode::DeviceLost);
        EXPECT_EQ(list.error().message.substr(0, 4), kind == SocketKind::Stream ? "tcp:" : "udp:");
    }
}

} // namespace
} // namespace halbench::devices
