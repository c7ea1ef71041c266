#include "control/base/random.h"
#include "devices/transport/message_stream.h"

#include <gtest/gtest.h>

namespace halbench::devices {
namespace {

using Octets = std::vector<std::uint8_t>;

TEST(MessageStream, messageHasLengthAndCounterLittleEndian) {
    Octets stream;
    appendMessage(stream, 0x1234, Octets{0xFF, 0x00});
    // LEN u16 | CTR u16 | PACKET (resources/help/protocol.md 3.2)
    EXPECT_EQ(stream, (Octets{0x02, 0x00, 0x34, 0x12, 0xFF, 0x00}));
}

TEST(MessageStream, messagesSurviveEverySplit) {
    Octets stream;
    std::vector<Octets> packets;
    for (std::size_t i = 0; i < 6; ++i) {
        packets.push_back(Octets(1 + 7 * i, static_cast<std::uint8_t>(i)));
        appendMessage(stream, static_cast<std::uint16_t>(65533 + i), packets.back());
    }
    for (std::size_t split = 0; split <= stream.size(); ++split) {
        MessageParser parser(255);
        std::vector<Octets> received;
        std::vector<std::uint16_t> counters;
        for (const auto& part : {std::span(stream).first(split), std::span(stream).subspan(split)}) {
            parser.feed(part);
            for (auto message = parser.next(); message && *message; message = parser.next()) {
                received.emplace_back((*message)->packet.begin(), (*message)->packet.end());
                counters.push_back((*message)->counter);
            }
        }
        ASSERT_EQ(received, packets) << "split at " << split;
        ASSERT_EQ(counters, (std::vector<std::uint16_t>{65533, 65534, 65535, 0, 1, 2}));
    }
}

TEST(MessageStream, nonsenseLengthIsAnErrorThatStays) {
    for (const Octets& header : {Octets{0, 0, 0, 0}, Octets{0x00, 0x01, 0, 0}}) {
        MessageParser parser(255);
        parser.feed(header);
        EXPECT_FALSE(parser.next());
        parser.feed(Octets{1, 0, 0, 0, 0xFF});
        const auto again = parser.next();
        ASSERT_FALSE(again);
        EXPECT_EQ(again.error().code, ErrorCode::Protocol);
    }
}

TEST(CounterWatch, countsGapsAcrossTheTurnAndNoStepsBack) {
    CounterWatch watch;
    EXPECT_EQ(watch.missingBefore(77), 0U) << "the first";
    watch.take(0xFFFD);
    EXPECT_EQ(watch.missingBefore(0xFFFE), 0U);
    EXPECT_EQ(watch.missingBefore(2), 4U);
    EXPECT_EQ(watch.missingBefore(0xFFFD), 0U) << "once more";
    EXPECT_EQ(watch.missingBefore(0xFFFB), 0U) << "overtaken";
}

TEST(DatagramWatch, dropsRepeatsAndWhatWasOvertakenAcrossTheTurn) {
    DatagramWatch watch;
    const auto take = [&](std::uint16_t counter) {
        return watch.take(counter, Octets{0xFF, static_cast<std::uint8_t>(counter)});
    };
    EXPECT_FALSE(take(0xFFFD).isStale) << "any start";
    EXPECT_TRUE(take(0xFFFD).isStale) << "a repeat";
    EXPECT_EQ(take(1).missing, 3U);
    for (const std::uint16_t late : std::initializer_list<std::uint16_t>{0xFFFE, 0, 0xFFFF, 1}) {
        const DatagramWatch::Arrival arrival = take(late);
        EXPECT_TRUE(arrival.isStale) << late;
        EXPECT_EQ(arrival.missing, 0U) << "counted when it was overtaken";
        EXPECT_EQ(arrival.isLate, late != 1) << "a repeat was not missing";
    }
    EXPECT_FALSE(take(0xFFFE).isLate) << "once more: it came by now";
    EXPECT_FALSE(take(2).isStale);
}

TEST(DatagramWatch, takesEverythingOfASideThatDoesNotCount) {
    DatagramWatch watch;
    EXPECT_FALSE(watch.take(0, Octets{0xFF, 0x01}).isStale);
    for (int i = 0; i < 3; ++i) {
        const DatagramWatch::Arrival arrival = watch.take(0, Octets{0xFF, 0x02});
        EXPECT_FALSE(arrival.isStale) << i;
        EXPECT_EQ(arrival.missing, 0U);
    }
}

} // namespace
} // namespace halbench::devices
