#include "tests/devices/transport/udp_pair.h"

#include <gtest/gtest.h>

namespace halbench::devices {
namespace {

// What becomes of a stream by UDP while the program is busy elsewhere: the system keeps some of it.

struct Flood : UdpPair {
    void connect() {
        ASSERT_TRUE(transport.open());
        ASSERT_TRUE(transport.send(Octets{0xFF, 0x00}));
        server.exchange(board);
        EXPECT_EQ(receive(), 1U);
    }
    /// Each packet in a datagram of its own, which is there before this returns.
    void send(std::size_t packets, std::size_t octets) {
        for (std::size_t i = 0; i < packets; ++i) {
            board.say(Octets(octets, 0x00));
            server.exchange(board);
        }
    }
    /// How many packets have arrived.
    std::size_t receive() {
        std::size_t count = 0;
        for (Octets packet; transport.receive(packet, 0.0).value_or(false);) {
            ++count;
        }
        return count;
    }
};

class UdpBuffer : public testing::TestWithParam<std::size_t> {};

TEST_P(UdpBuffer, keepsWhatItSaysWhileNobodyReceivesAndTheRestIsCounted) {
    Flood flood;
    ASSERT_NO_FATAL_FAILURE(flood.connect());
    const std::size_t kept = flood.transport.keptDatagrams(GetParam());
    ASSERT_GT(kept, 50U);
    // A second of the fastest stream is asked for, of which the system may give less.
    ASSERT_LE(kept, 40000U);
    // The system may count them smaller than is reckoned with: by less than a half.
    const std::size_t sent = kept + kept / 2;
    flood.send(sent, GetParam());
    const std::size_t arrived = flood.receive();
    EXPECT_GE(arrived, kept);
    flood.send(1, GetParam()); // behind the gap
    EXPECT_EQ(flood.receive(), 1U);
    EXPECT_EQ(flood.transport.statistics().packetsLost, sent - arrived);
}

INSTANTIATE_TEST_SUITE_P(Octets, UdpBuffer, testing::Values(6, 60, 133, 300, 500));

TEST(UdpBufferRemark, isMadeOfAStreamOfWhichLessThanAFifthOfASecondIsKept) {
    Flood flood;
    ASSERT_NO_FATAL_FAILURE(flood.connect());
    const auto kept = static_cast<double>(flood.transport.keptDatagrams(20));
    EXPECT_FALSE(flood.transport.remarkOnStream(kept / 0.21, 20));
    const auto remark = flood.transport.remarkOnStream(kept / 0.1, 20);
    ASSERT_TRUE(remark);
    EXPECT_NE(remark->find("100 ms"), std::string::npos) << *remark;
    // What is missing is as much again: the system counts twice what it is told.
    EXPECT_NE(remark->find("net.core.rmem_max="), std::string::npos) << *remark;
}

} // namespace
} // namespace halbench::devices
