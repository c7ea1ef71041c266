#include "devices/open/sxi_framing.h"
#include "devices/transport/codec_framing.h"
#include "devices/transport/faulty_line.h"
#include "devices/transport/sxi_codec.h"
#include "devices/xcp/xcp_device.h"
#include "tests/devices/transport/echo_board.h"
#include "tests/devices/transport/virtual_line.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace halbench::devices {
namespace {

constexpr int Messages = 20000;

/// Four standard deviations of a binomial count: one seed in 16 000 would be outside.
void expectBinomial(std::uint64_t count, std::uint64_t of, double ratio) {
    const double mean = ratio * static_cast<double>(of);
    const double deviation = std::sqrt(mean * (1.0 - ratio));
    EXPECT_NEAR(static_cast<double>(count), mean, 4.0 * deviation) << "of " << of;
}

int bitsApart(const Octets& a, const Octets& b) {
    int bits = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        bits += __builtin_popcount(static_cast<unsigned>(a[i] ^ b[i]));
    }
    return bits;
}

TEST(FaultyBoard, withoutFaultsPassesEverythingOnAtOnce) {
    EchoBoard board;
    LineTraffic traffic;
    FaultyBoard line(board, {}, Random(1), traffic);
    line.receive(Octets{0xFD, 0x01});
    Octets packet;
    std::uint16_t counter = 0;
    ASSERT_TRUE(line.transmit(packet, counter));
    EXPECT_EQ(packet, (Octets{0xFF, 0xFD, 0x01}));
    EXPECT_FALSE(line.transmit(packet, counter));
    EXPECT_EQ(traffic.messages, 2U);
    EXPECT_EQ(traffic.dropped + traffic.corrupted, 0U);
}

TEST(FaultyBoard, dropsItsShareOfEachDirectionAndTheCounterShowsIt) {
    constexpr double Share = 0.01;
    EchoBoard board;
    LineTraffic traffic;
    FaultyBoard line(board, {Share, 0.0, 0.0}, Random(7), traffic);
    Octets packet;
    std::uint16_t counter = 0;
    std::uint64_t received = 0;
    std::uint64_t lost = 0;
    CounterWatch counters;
    for (int i = 0; i < Messages; ++i) {
        line.receive(Octets{0xFD});
        while (line.transmit(packet, counter)) {
            ++received;
            lost += counters.missingBefore(counter);
            counters.take(counter);
            EXPECT_EQ(packet, (Octets{0xFF, 0xFD}));
        }
    }
    expectBinomial(Messages - board.received.size(), Messages, Share);
    expectBinomial(lost, received + lost, Share);
    EXPECT_EQ(traffic.dropped, Messages - received);
    EXPECT_EQ(traffic.messages, Messages + board.received.size());
}

TEST(FaultyBoard, damagesOneBitOfItsShareOfTheMessages) {
    constexpr double Share = 0.02;
    EchoBoard board;
    LineTraffic traffic;
    FaultyBoard line(board, {0.0, Share, 0.0}, Random(7), traffic);
    const Octets command{0xFD, 0x55, 0xAA, 0x00, 0xFF};
    std::uint64_t damaged = 0;
    for (int i = 0; i < Messages; ++i) {
        line.receive(command);
        ASSERT_EQ(board.received.back().size(), command.size());
        const int bits = bitsApart(board.received.back(), command);
        ASSERT_LE(bits, 1);
        damaged += bits == 1 ? 1 : 0;
    }
    expectBinomial(damaged, Messages, Share);
    EXPECT_EQ(traffic.corrupted, damaged);
}

TEST(FaultyBoard, deliversLateInOrderAndAtTheRightTimeOfTheBoard) {
    EchoBoard board;
    LineTraffic traffic;
    FaultyBoard line(board, {0.0, 0.0, 0.020}, Random(1), traffic);
    Octets packet;
    std::uint16_t counter = 0;
    line.advanceTo(1.0);
    line.receive(Octets{0x01});
    line.advanceTo(1.005);
    line.receive(Octets{0x02});
    line.advanceTo(1.019);
    EXPECT_TRUE(board.received.empty());
    line.advanceTo(1.021);
    EXPECT_EQ(board.received, std::vector<Octets>{{0x01}});
    EXPECT_FALSE(line.transmit(packet, counter)) << "the answer has its own way to go";
    line.advanceTo(1.030);
    EXPECT_EQ(board.received.size(), 2U);
    EXPECT_FALSE(line.transmit(packet, counter));
    line.advanceTo(1.042);
    ASSERT_TRUE(line.transmit(packet, counter));
    EXPECT_EQ(packet, (Octets{0xFF, 0x01}));
    EXPECT_FALSE(line.transmit(packet, counter));
    line.advanceTo(1.051);
    ASSERT_TRUE(line.transmit(packet, counter));
    EXPECT_EQ(packet, (Octets{0xFF, 0x02}));
}

TEST(FaultyBoard, aMasterThatReadsNothingFillsTheLineAndThenTheBoard) {
    EchoBoard board;
    LineTraffic traffic;
    FaultyBoard line(board, {0.0, 0.0, 1.0}, Random(1), traffic);
    for (std::size_t i = 0; i < FaultyBoard::MaxOnTheWay + 10; ++i) {
        board.say({0x01});
    }
    Octets packet;
    std::uint16_t counter = 0;
    EXPECT_FALSE(line.transmit(packet, counter));
    EXPECT_EQ(traffic.messages, FaultyBoard::MaxOnTheWay);
    EXPECT_FALSE(board.hasSaidEverything());
}

/// Every damaged frame is noticed by the codec of the other side or lost to it; nothing wrong passes.
TEST(FaultyFraming, damageIsSeenByBothReceivers) {
    constexpr double Share = 0.05;
    LineTraffic traffic;
    FaultyFraming line(std::make_unique<SxiFraming>(), SxiProfile{}, Share, Random(3), traffic);
    SxiCodec master{SxiProfile{}};
    const Octets packet{0xFF, 0x9A, 0x9B, 0x10, 0x20, 0x30, 0x40};
    std::uint64_t heard = 0;
    Octets stream;
    for (int i = 0; i < Messages; ++i) {
        stream.clear();
        line.append(stream, static_cast<std::uint16_t>(i), packet);
        master.feed(stream);
        for (auto frame = master.next(); frame && *frame; frame = master.next()) {
            ASSERT_TRUE(std::equal(packet.begin(), packet.end(), (*frame)->packet.begin()));
            ++heard;
        }
    }
    expectBinomial(traffic.corrupted, Messages, Share);
    // A damaged SYNC loses its frame, one that came to be in the middle costs none but its own.
    EXPECT_NEAR(static_cast<double>(heard + traffic.corrupted), Messages, 1.0);

    traffic = {};
    heard = 0;
    for (int i = 0; i < Messages; ++i) {
        stream.clear();
        master.append(stream, static_cast<std::uint16_t>(i), Octets{0xFD});
        for (const std::uint8_t octet : stream) {
            const auto taken = line.receive(octet);
            if (!taken.empty()) {
                EXPECT_EQ(taken[0], 0xFD);
                ++heard;
            }
        }
    }
    EXPECT_NEAR(static_cast<double>(traffic.corrupted), Share * Messages, 0.2 * Share * Messages);
    EXPECT_GE(heard + traffic.corrupted, static_cast<std::uint64_t>(Messages) - 1);
}

/// Without framing a damaged command costs those up to the next silence, and nothing wrong passes the sum.
TEST(FaultyFraming, damageWithoutFramingIsSeenByTheBoard) {
    constexpr double Share = 0.05;
    const SxiProfile plain{SxiHeader::LenCtrByte, SxiChecksum::Word, false};
    LineTraffic traffic;
    FaultyFraming line(std::make_unique<CodecFraming>(plain), plain, Share, Random(3), traffic);
    SxiCodec master(plain);
    std::uint64_t heard = 0;
    Octets stream;
    for (int i = 0; i < Messages; ++i) {
        stream.clear();
        master.append(stream, static_cast<std::uint16_t>(i), Octets{0xFD});
        line.noteSilence();
        for (const std::uint8_t octet : stream) {
            const auto taken = line.receive(octet);
            if (!taken.empty()) {
                EXPECT_EQ(Octets(taken.begin(), taken.end()), Octets{0xFD});
                ++heard;
            }
        }
    }
    expectBinomial(traffic.corrupted, Messages, Share);
    EXPECT_EQ(heard + traffic.corrupted, static_cast<std::uint64_t>(Messages));
}

TEST(LineFaults, refusesNonsenseByTheNameOfTheOption) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(checkLineFaults({}));
    EXPECT_TRUE(checkLineFaults({1.0, 1.0, LineFaults::MaxLatency_s}));
    const std::vector<std::pair<LineFaults, std::string>> wrong = {
        {{2.0, 0.0, 0.0}, "--drop"},        {{-0.1, 0.0, 0.0}, "--drop"},
        {{nan, 0.0, 0.0}, "--drop"},        {{0.0, 1.01, 0.0}, "--corrupt"},
        {{0.0, nan, 0.0}, "--corrupt"},     {{0.0, 0.0, -1e-3}, "--latency-ms"},
        {{0.0, 0.0, 10.1}, "--latency-ms"}, {{0.0, 0.0, nan}, "--latency-ms"},
        {{0.0, 0.0, 1e9}, "--latency-ms"},
    };
    for (const auto& [faults, option] : wrong) {
        const auto checked = checkLineFaults(faults);
        ASSERT_FALSE(checked) << option;
        EXPECT_NE(checked.error().message.find(option), std::string::npos) << checked.error().message;
        EXPECT_FALSE(checked.error().hint.empty());
    }
}

/// The whole way: a master connects, streams for ten seconds and its statistics tell the share that was lost.
TEST(FaultyLine, statisticsOfTheMasterShowTheDropRate) {
    constexpr double Share = 0.02;
    auto line = std::make_unique<VirtualLine>("imperfections=off", LineFaults{Share, 0.0, 0.005}, 11);
    const VirtualLine& watched = *line;
    const auto device = openXcpDevice(std::move(line), {});
    ASSERT_TRUE(device) << device.error().message;
    Recording recording;
    ASSERT_TRUE((*device)->startStream({{"position"}, 500.0},
                                       [&](const SampleBlockPtr& block) { recording.append(*block); }));
    ASSERT_TRUE((*device)->clock().waitFor(10.0));
    const LinkStatistics seen = (*device)->statistics();
    expectBinomial(seen.packetsLost, seen.packetsLost + seen.packetsReceived, Share);
    expectBinomial(watched.traffic().dropped, watched.traffic().messages, Share);
    const double span = std::round((recording.time_s.back() - recording.time_s.front()) * 500.0) + 1.0;
    EXPECT_EQ(static_cast<double>(recording.rows() + recording.lostRows), span) << "every gap is counted";
    expectBinomial(recording.lostRows, recording.rows() + recording.lostRows, Share);
}

} // namespace
} // namespace halbench::devices
