#include "tests/conformance/transport/far_end.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <numeric>
#include <thread>

namespace halbench::devices {

namespace {

const Octets First{0xFF, 0x9A, 0x9B, 0x00};
const Octets Second{0x01, 0x9A};
const Octets Third{0xFD, 0x12, 0x34};
constexpr int Cycles = 100;

Octets operator+(Octets a, const Octets& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

Octets part(const Octets& octets, std::size_t begin, std::size_t end) {
    return {octets.begin() + static_cast<std::ptrdiff_t>(begin),
            octets.begin() + static_cast<std::ptrdiff_t>(end)};
}

/// 1, 2, 3 ... octets, every value among them.
std::vector<Octets> packetsOfAllValues() {
    std::vector<Octets> packets;
    std::uint8_t value = 0;
    for (std::size_t size = 1; size <= 60; ++size) {
        Octets packet(size);
        std::generate(packet.begin(), packet.end(), [&value] { return value++; });
        packets.push_back(std::move(packet));
    }
    return packets;
}

} // namespace

// Not every program that runs the suite has every kind of line.
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(DatagramConformance);

TEST_P(TransportConformance, carriesEveryOctetBothWays) {
    connect(*m_transport);
    const std::vector<Octets> packets = packetsOfAllValues();
    std::uint16_t counter = 0;
    for (const Octets& packet : packets) {
        ASSERT_TRUE(m_transport->send(packet));
        m_far->deliver(framed(counter++, packet));
    }
    EXPECT_EQ(packetsTaken(packets.size()), packets);
    EXPECT_EQ(received(*m_transport, packets.size()), packets);
    const TransportStatistics seen = m_transport->statistics();
    EXPECT_EQ(seen.packetsReceived, packets.size());
    EXPECT_EQ(seen.packetsSent, packets.size() + 1) << "and the greeting";
    EXPECT_EQ(seen.packetsLost, 0U);
    EXPECT_EQ(seen.packetsDamaged, 0U);
}

TEST_P(StreamConformance, readsSplitAtEveryPositionGiveTheSamePackets) {
    connect(*m_transport);
    const Octets line = framed(0, First) + framed(1, Second);
    for (std::size_t cut = 1; cut < framed(0, First).size(); ++cut) {
        deliverAlone(*m_transport, part(line, 0, cut));
        m_far->deliver(part(line, cut, line.size()));
        m_delivered += line.size() - cut;
        ASSERT_EQ(received(*m_transport, 2), (std::vector<Octets>{First, Second})) << "cut at " << cut;
    }
    for (const std::uint8_t octet : line) { // and octet by octet
        m_far->deliver({octet});
    }
    EXPECT_EQ(received(*m_transport, 2), (std::vector<Octets>{First, Second}));
    EXPECT_EQ(m_transport->statistics().packetsLost + m_transport->statistics().packetsDamaged, 0U);
}

TEST_P(TransportConformance, readsThatHoldManyPacketsGiveThemAll) {
    connect(*m_transport);
    std::uint16_t number = 0;
    for (std::uint16_t count = 1; count <= 40; ++count) {
        Octets merged;
        for (std::uint16_t i = 0; i < count; ++i) {
            merged = merged + framed(number++, Second);
        }
        m_far->deliver(merged);
        EXPECT_EQ(received(*m_transport, count), std::vector<Octets>(count, Second));
    }
}

TEST_P(TransportConformance, lostPacketsAreCountedAndRepeatedOnesAreNot) {
    connect(*m_transport);
    const std::uint16_t nearEnd = m_traits.counterMask;
    m_far->deliver(framed(static_cast<std::uint16_t>(nearEnd - 5), First));
    m_far->deliver(framed(static_cast<std::uint16_t>(nearEnd - 5), First)); // once more
    m_far->deliver(framed(static_cast<std::uint16_t>(nearEnd - 3), First)); // one is missing
    m_far->deliver(framed(static_cast<std::uint16_t>(nearEnd + 4), First)); // six, across the turn
    m_far->deliver(framed(static_cast<std::uint16_t>(nearEnd + 3), First)); // one that was overtaken
    // A network repeats and overtakes, which would put an old answer under a new command; a line does
    // neither.
    const std::size_t kept = m_traits.isDatagram ? 3 : 5;
    EXPECT_EQ(received(*m_transport, kept), std::vector<Octets>(kept, First));
    EXPECT_EQ(m_transport->statistics().packetsLost, 7U);
}

/// One octet of a message is changed, missing or twice there, at each position. Lines with a checksum lose
/// this message alone. The others cannot see damage inside; whatever their lengths then say, every call
/// returns and a line opened anew is whole.
TEST_P(TransportConformance, damageAnywhereCostsNoMoreThanItMust) {
    enum class Damage { Changed, Lost, Repeated };
    const std::size_t size = framed(0, Third).size();
    for (const Damage damage : {Damage::Changed, Damage::Lost, Damage::Repeated}) {
        for (std::size_t at = 0; at < size; ++at) {
            constexpr std::size_t Header = 4;
            if (m_traits.isDatagram && at < Header) {
                continue; // a counter of the future makes what follows stale; UDP's own checksum drops it
                          // before
            }
            connect(*m_transport);
            Octets line = framed(7, Third);
            const auto place = line.begin() + static_cast<std::ptrdiff_t>(at);
            if (damage == Damage::Changed) {
                *place ^= 0x21;
            } else if (damage == Damage::Lost) {
                line.erase(place);
            } else {
                line.insert(place, *place);
            }
            m_far->deliver(line);
            m_far->deliver(framed(8, First));
            m_far->deliver(framed(9, Second));
            std::vector<Octets> packets;
            Octets packet;
            for (;;) {
                const double wait_s = m_traits.hasChecksum || m_traits.isDatagram ? Patience_s : 0.02;
                const auto taken = m_transport->receive(packet, wait_s);
                if (!taken || !*taken || (packets.push_back(packet), packets.back() == Second)) {
                    break;
                }
            }
            SCOPED_TRACE(testing::Message() << "damage " << static_cast<int>(damage) << " at " << at);
            ASSERT_LE(packets.size(), 4U);
            if (m_traits.hasChecksum || m_traits.isDatagram) {
                ASSERT_GE(packets.size(), 2U);
                EXPECT_EQ(packets.back(), Second);
                EXPECT_EQ(packets[packets.size() - 2], First);
            }
            for (std::size_t i = 0; m_traits.hasChecksum && i + 2 < packets.size(); ++i) {
                EXPECT_EQ(packets[i], Third) << "a repeated SYNC damages nothing";
            }
            m_transport->close();
        }
    }
}

TEST_P(DatagramConformance, aDatagramThatIsNoWholeMessageIsDroppedWhereverItWasCut) {
    connect(*m_transport);
    std::uint16_t number = 0;
    const std::size_t wholeSize = framed(0, Third).size();
    for (std::size_t size = 0; size < wholeSize; ++size) {
        m_far->deliver(part(framed(number++, Third), 0, size));
        m_far->deliver(framed(number++, First));
        EXPECT_EQ(received(*m_transport, 1), std::vector<Octets>{First}) << size;
    }
    m_far->deliver(framed(number, First) + part(framed(static_cast<std::uint16_t>(number + 1), Third), 0, 5));
    number = static_cast<std::uint16_t>(number + 2);
    m_far->deliver(framed(number++, Second));
    EXPECT_EQ(received(*m_transport, 2), (std::vector<Octets>{First, Second}));
    m_far->deliver(Octets(40, 0)); // messages of no length
    m_far->deliver(framed(number, Second));
    EXPECT_EQ(received(*m_transport, 1), std::vector<Octets>{Second});
    EXPECT_GE(m_transport->statistics().packetsDamaged, 1U);
}

TEST_P(UncheckedStreamConformance, nonsenseEndsAStreamAtOnceAndInItsOwnWords) {
    connect(*m_transport);
    m_far->deliver(Octets(8, 0)); // a message of no length
    Octets packet;
    const auto ended = m_transport->receive(packet, Patience_s);
    ASSERT_FALSE(ended);
    EXPECT_NE(ended.error().message.find("0 bytes"), std::string::npos) << ended.error().message;
    EXPECT_EQ(m_transport->statistics().packetsDamaged, 1U);
    connect(*m_transport);
    m_far->deliver(framed(0, First));
    EXPECT_EQ(received(*m_transport, 1), std::vector<Octets>{First});
}

TEST_P(TransportConformance, aReceiveThatNothingComesForTakesItsTimeAndNoMore) {
    connect(*m_transport);
    Octets packet;
    for (const double timeout_s : {0.0, 0.01, 0.05}) {
        const double start_s = m_transport->now_s();
        const auto taken = m_transport->receive(packet, timeout_s);
        const double elapsed_s = m_transport->now_s() - start_s;
        ASSERT_TRUE(taken);
        EXPECT_FALSE(*taken);
        EXPECT_GE(elapsed_s, timeout_s - 1e-3) << "poll() counts whole milliseconds";
        EXPECT_LT(elapsed_s, timeout_s + 1.0) << "a busy machine's share";
    }
    m_far->deliver(framed(0, First));
    EXPECT_EQ(received(*m_transport, 1), std::vector<Octets>{First}) << "a time-out loses nothing";
}

TEST_P(StallConformance, aBoardThatTakesNothingIsGivenUpWithinTwoSeconds) {
    connect(*m_transport);
    m_far->setStalled(true);
    const Octets packet(250, 0x55);
    Result<void> sent;
    double longest_s = 0.0;
    for (int i = 0; i < 200000 && sent; ++i) { // more than any buffer of the system holds
        const double start_s = m_transport->now_s();
        sent = m_transport->send(packet);
        longest_s = std::max(longest_s, m_transport->now_s() - start_s);
    }
    ASSERT_FALSE(sent);
    EXPECT_EQ(sent.error().code, ErrorCode::DeviceLost);
    EXPECT_NE(sent.error().message.find("accepts no more"), std::string::npos) << sent.error().message;
    EXPECT_LT(longest_s, Patience_s);
    EXPECT_FALSE(m_transport->send(packet)) << "given up means closed";
    m_far->setStalled(false);
}

TEST_P(TransportConformance, aClosedTransportSaysSoAndClosingTwiceIsHarmless) {
    Octets packet;
    for (int round = 0; round < 2; ++round) {
        const auto sent = m_transport->send(Hello);
        const auto taken = m_transport->receive(packet, 0.0);
        ASSERT_FALSE(sent);
        ASSERT_FALSE(taken);
        EXPECT_EQ(sent.error().code, ErrorCode::DeviceLost);
        EXPECT_EQ(taken.error().code, ErrorCode::DeviceLost);
        EXPECT_FALSE(sent.error().hint.empty());
        connect(*m_transport);
        m_transport->close();
        m_transport->close();
    }
}

TEST_P(TransportConformance, aLineOpenedAnewKnowsNothingOfTheOldOne) {
    for (int round = 0; round < 20; ++round) {
        connect(*m_transport);
        m_far->deliver(framed(200, Second));
        EXPECT_EQ(received(*m_transport, 1), std::vector<Octets>{Second}) << round;
        m_delivered += framed(200, Second).size();
        deliverAlone(*m_transport, part(framed(201, First), 0, 5)); // half a message, and gone
        m_transport->close();
    }
    EXPECT_EQ(m_transport->statistics().packetsLost, 0U) << "a counter that begins anew is no loss";
}

TEST_P(TransportConformance, aSecondOpenIsRefusedOrHarmsNobody) {
    connect(*m_transport);
    const auto second = m_far->makeTransport();
    const Result<void> opened = second->open();
    ASSERT_EQ(opened.has_value(), !m_traits.isExclusive);
    if (m_traits.isExclusive) {
        EXPECT_EQ(opened.error().code, ErrorCode::DeviceLost);
        EXPECT_NE(opened.error().message.find("in use"), std::string::npos) << opened.error().message;
        EXPECT_FALSE(opened.error().hint.empty());
        m_far->deliver(framed(0, First));
        EXPECT_EQ(received(*m_transport, 1), std::vector<Octets>{First}) << "the first goes on";
    }
    m_transport->close();
    second->close();
    connect(*second);
    m_far->deliver(framed(0, First));
    EXPECT_EQ(received(*second, 1), std::vector<Octets>{First}) << "closed means free";
}

TEST_P(TransportConformance, anUnplugIsToldInEveryState) {
    enum class State { Idle, Receiving, HalfAMessage, Unread };
    for (const State state : {State::Idle, State::Receiving, State::HalfAMessage, State::Unread}) {
        SCOPED_TRACE(static_cast<int>(state));
        connect(*m_transport);
        std::thread hand;
        if (state == State::HalfAMessage) {
            m_far->deliver(part(framed(0, First), 0, 5));
        } else if (state == State::Unread) {
            m_far->deliver(framed(0, First));
            EXPECT_EQ(received(*m_transport, 1), std::vector<Octets>{First});
            m_far->deliver(framed(1, Second));
        }
        if (state == State::Receiving) {
            hand = std::thread([this] { m_far->unplug(); }); // before or while receive() waits
        } else {
            m_far->unplug();
        }
        Error error;
        ASSERT_TRUE(isToldLost(*m_transport, error)) << "within 2 s";
        EXPECT_EQ(error.code, ErrorCode::DeviceLost);
        EXPECT_FALSE(error.message.empty() || error.hint.empty());
        if (hand.joinable()) {
            hand.join();
        }
        Octets packet;
        EXPECT_FALSE(m_transport->receive(packet, 0.0)) << "lost is lost";
        EXPECT_FALSE(m_transport->send(Hello));
        m_transport->close();
        m_far->plug();
    }
    m_far->unplug();
    const Result<void> opened = m_transport->open();
    const bool isNoticed = !opened || !m_traits.tellsUnplugByItself;
    EXPECT_TRUE(isNoticed) << "a line that is not there cannot be opened";
    m_transport->close();
    m_far->plug();
    connect(*m_transport);
}

TEST_P(TransportConformance, hundredTimesUnpluggedAndPluggedInAgain) {
    for (int cycle = 0; cycle < Cycles; ++cycle) {
        connect(*m_transport);
        ASSERT_FALSE(HasFatalFailure()) << cycle;
        m_far->deliver(framed(0, First));
        ASSERT_EQ(received(*m_transport, 1), std::vector<Octets>{First});
        m_far->unplug();
        Error error;
        ASSERT_TRUE(isToldLost(*m_transport, error)) << cycle;
        m_far->plug();
    }
}

TEST_P(TransportConformance, closesAndReopensWhilePacketsPourIn) {
    std::atomic<bool> hasEnded{false};
    connect(*m_transport);
    std::thread board([&] {
        for (std::uint16_t counter = 0; !hasEnded; ++counter) {
            m_far->deliver(framed(counter, First));
        }
    });
    Octets packet;
    for (int round = 0; round < 20; ++round) {
        const auto taken = m_transport->receive(packet, Patience_s);
        EXPECT_TRUE(taken && *taken) << round;
        m_transport->close();
        EXPECT_TRUE(m_transport->open());
        EXPECT_TRUE(m_transport->send(Hello));
        (void)m_far->taken();
    }
    hasEnded = true;
    board.join();
}

} // namespace halbench::devices
