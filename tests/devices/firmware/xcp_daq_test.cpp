#include "tests/devices/firmware/board_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace halbench::devices::firmware {
namespace {

constexpr std::uint8_t TimestampOn = 0x10;

struct Entry {
    std::uint32_t address;
    std::uint8_t size;
};

Octets writeDaq(const Entry& entry) {
    Octets packet{0xE1, 0xFF, entry.size, 0};
    const Octets address = BoardFixture::le32(entry.address);
    packet.insert(packet.end(), address.begin(), address.end());
    return packet;
}

/// One list on `event`, each inner vector one ODT (resources/help/protocol.md 3.8).
void startList(BoardFixture& f, const std::vector<std::vector<Entry>>& odts, std::uint8_t event,
               std::uint8_t prescaler = 1, std::uint8_t mode = TimestampOn) {
    ASSERT_EQ(f.command({0xD6}), Accepted);
    ASSERT_EQ(f.command({0xD5, 0, 1, 0}), Accepted);
    ASSERT_EQ(f.command({0xD4, 0, 0, 0, static_cast<std::uint8_t>(odts.size())}), Accepted);
    for (std::size_t odt = 0; odt < odts.size(); ++odt) {
        ASSERT_EQ(f.command({0xD3, 0, 0, 0, static_cast<std::uint8_t>(odt),
                             static_cast<std::uint8_t>(odts[odt].size())}),
                  Accepted);
    }
    for (std::size_t odt = 0; odt < odts.size(); ++odt) {
        ASSERT_EQ(f.command({0xE2, 0, 0, 0, static_cast<std::uint8_t>(odt), 0}), Accepted);
        for (const Entry& entry : odts[odt]) {
            ASSERT_EQ(f.command(writeDaq(entry)), Accepted);
        }
    }
    ASSERT_EQ(f.command({0xE0, mode, 0, 0, event, 0, prescaler, 0}), Accepted);
    ASSERT_EQ(f.command({0xDE, 2, 0, 0}), (Octets{0xFF, 0}));
    ASSERT_EQ(f.command({0xDD, 1}), Accepted);
}

TEST(XcpDaq, announcesItsAbilities) {
    BoardFixture f;
    f.connect();
    EXPECT_EQ(f.command({0xDA}), (Octets{0xFF, 0x93, HB_DAQ_LISTS, 0, 2, 0, 0, 0}));
    // 4 octet time stamp in units of 1 us, one tick a unit, entries of 1..8 octets
    EXPECT_EQ(f.command({0xD9}), (Octets{0xFF, 1, 8, 1, 0, 0x34, 1, 0}));
    f.tick(5);
    const Octets clock = f.command({0xDC});
    EXPECT_EQ(clock[3], 1);
    EXPECT_EQ(BoardFixture::u32(clock, 4), 4000U); // the fifth tick began at 4 ms
}

TEST(XcpDaq, namesItsEvents) {
    BoardFixture f;
    f.connect();
    const Octets fast = f.command({0xD7, 0, 0, 0});
    EXPECT_EQ(fast, (Octets{0xFF, 0x04, HB_DAQ_LISTS, 4, 1, 6, 0})); // every 1 unit of 1 ms
    const Octets name = f.command({0xF5, 4});
    EXPECT_EQ(std::string(name.begin() + 1, name.end()), "fast");
    const Octets position = f.command({0xD7, 0, 1, 0});
    EXPECT_EQ(position[4], 10);
    const Octets other = f.command({0xF5, 8});
    EXPECT_EQ(std::string(other.begin() + 1, other.end()), "position");
    EXPECT_EQ(f.command({0xD7, 0, 2, 0}), refused(0x22));
}

TEST(XcpDaq, packsASampleWithItsTimeStamp) {
    BoardFixture f;
    f.angle_rad = 1.0;
    f.connect();
    startList(f, {{{0, 4}, {8 * 10, 1}}, {{8 * 6, 4}}}, 0); // position, status | hall.a
    f.tick(2);
    const std::vector<Octets> packets = f.received();
    ASSERT_EQ(packets.size(), 4U);
    const Octets& first = packets[2];
    ASSERT_EQ(first.size(), 1U + 4 + 4 + 1);
    EXPECT_EQ(first[0], 0);
    EXPECT_EQ(BoardFixture::u32(first, 1), 1000U);
    // 1 rad = 2^18/(2 pi) = 41721.5 counts; the float angle is good to 1e-7, so one count of room
    EXPECT_NEAR(static_cast<double>(static_cast<std::int32_t>(BoardFixture::u32(first, 5))),
                262144.0 / (2 * Pi), 1.0);
    EXPECT_EQ(first[9], HB_STATUS_IDLE);
    const Octets& second = packets[3];
    ASSERT_EQ(second.size(), 5U); // no time stamp in the second packet of a sample
    EXPECT_EQ(second[0], 1);
    const std::uint32_t bits = BoardFixture::u32(second, 1);
    float hall;
    std::memcpy(&hall, &bits, sizeof hall);
    EXPECT_NEAR(hall, FieldAmplitude_T * std::cos(1.0), 1e-7);
}

TEST(XcpDaq, keepsThePeriodOfEventAndPrescaler) {
    const auto times = [](std::uint8_t event, std::uint8_t prescaler) {
        BoardFixture f;
        f.connect();
        startList(f, {{{0, 4}}}, event, prescaler);
        f.tick(100);
        std::vector<std::uint32_t> result;
        for (const Octets& packet : f.received()) {
            result.push_back(BoardFixture::u32(packet, 1));
        }
        return result;
    };
    EXPECT_EQ(times(0, 1).size(), 100U);
    EXPECT_EQ(times(0, 30), (std::vector<std::uint32_t>{0, 30000, 60000, 90000}));
    EXPECT_EQ(times(1, 1).size(), 10U);
    EXPECT_EQ(times(1, 4), (std::vector<std::uint32_t>{0, 40000, 80000}));
}

TEST(XcpDaq, leavesOutTheTimeStampWhenNotAsked) {
    BoardFixture f;
    f.connect();
    startList(f, {{{0, 4}}}, 0, 1, 0);
    f.tick();
    EXPECT_EQ(f.received().at(0).size(), 5U);
}

TEST(XcpDaq, servesTheCallersOwnSignals) {
    const double truth = 1.23456789012345;
    const hb_signal signal = truthSignal();
    hb_htm_config config{};
    config.extra = {&signal, 1, &truth};
    BoardFixture f(&config);
    f.connect();
    const std::uint32_t handle = 8U * hb_xcp_description(f.board().board.xcp.description).signals[0].count;
    startList(f, {{{handle, 8}}}, 0);
    f.tick();
    const Octets packet = f.received().at(0);
    double value;
    std::memcpy(&value, &packet[5], sizeof value);
    EXPECT_EQ(value, truth);
    EXPECT_EQ(f.read(handle, 8).size(), 9U);
}

TEST(XcpDaq, refusesTheWrongOrderOfAllocation) {
    BoardFixture f;
    f.connect();
    EXPECT_EQ(f.command({0xD5, 0, 1, 0}), refused(0x29)); // ALLOC_DAQ before FREE_DAQ
    f.command({0xD6});
    EXPECT_EQ(f.command({0xD4, 0, 0, 0, 1}), refused(0x29));
    EXPECT_EQ(f.command({0xD5, 0, 1, 0}), Accepted);
    EXPECT_EQ(f.command({0xD3, 0, 0, 0, 0, 1}), refused(0x29));
    EXPECT_EQ(f.command({0xD4, 0, 0, 0, 1}), Accepted);
    EXPECT_EQ(f.command({0xD4, 0, 0, 0, 1}), refused(0x29)); // the same list twice
    EXPECT_EQ(f.command({0xD3, 0, 0, 0, 0, 2}), Accepted);
    EXPECT_EQ(f.command({0xD4, 0, 0, 0, 1}), refused(0x29));
    EXPECT_EQ(f.command(writeDaq({0, 4})), refused(0x29)); // no SET_DAQ_PTR yet
    EXPECT_EQ(f.command({0xDE, 2, 0, 0}), refused(0x2A));  // entries not written
}

TEST(XcpDaq, refusesWhatDoesNotFit) {
    BoardFixture f;
    f.connect();
    f.command({0xD6});
    EXPECT_EQ(f.command({0xD5, 0, HB_DAQ_LISTS + 1, 0}), refused(0x30));
    EXPECT_EQ(f.command({0xD5, 0, 2, 0}), Accepted);
    EXPECT_EQ(f.command({0xD4, 0, 2, 0, 1}), refused(0x22));
    EXPECT_EQ(f.command({0xD4, 0, 0, 0, HB_DAQ_ODTS + 1}), refused(0x30));
    EXPECT_EQ(f.command({0xD4, 0, 0, 0, 3}), Accepted);
    EXPECT_EQ(f.command({0xD3, 0, 0, 0, 3, 1}), refused(0x22));
    EXPECT_EQ(f.command({0xD3, 0, 0, 0, 0, 255}), Accepted);
    EXPECT_EQ(f.command({0xD3, 0, 0, 0, 1, 255}), Accepted);
    EXPECT_EQ(f.command({0xD3, 0, 0, 0, 2, 255}), refused(0x30)); // 765 of 512 entries
    EXPECT_EQ(f.command({0xE2, 0, 0, 0, 0, 255}), refused(0x22));
    EXPECT_EQ(f.command({0xE2, 0, 0, 0, 0, 0}), Accepted);
    EXPECT_EQ(f.command(writeDaq({8 * 300, 4})), refused(0x24)); // no such signal
    EXPECT_EQ(f.command(writeDaq({0, 8})), refused(0x24));       // longer than the signal
    EXPECT_EQ(f.command(writeDaq({0, 0})), refused(0x22));
    for (int i = 0; i < (HB_MAX_DTO - 5) / 4; ++i) {
        ASSERT_EQ(f.command(writeDaq({0, 4})), Accepted);
    }
    EXPECT_EQ(f.command(writeDaq({0, 4})), refused(0x2A));                      // the packet is full
    EXPECT_EQ(f.command({0xE0, TimestampOn, 0, 0, 7, 0, 1, 0}), refused(0x22)); // no such event
    EXPECT_EQ(f.command({0xE0, TimestampOn, 0, 0, 0, 0, 0, 0}), refused(0x22)); // prescaler 0
    EXPECT_EQ(f.command({0xE0, 0x02, 0, 0, 0, 0, 1, 0}), refused(0x27));        // stimulation
}

TEST(XcpDaq, locksARunningList) {
    BoardFixture f;
    f.connect();
    startList(f, {{{0, 4}}}, 0);
    EXPECT_EQ(f.command({0xFD})[1], 0x40);
    EXPECT_EQ(f.command({0xE2, 0, 0, 0, 0, 0}), refused(0x11));
    EXPECT_EQ(f.command({0xE0, 0, 0, 0, 0, 0, 1, 0}), refused(0x11));
    EXPECT_EQ(f.command({0xD5, 0, 1, 0}), refused(0x11));
    EXPECT_EQ(f.command({0xDF, 0, 0, 0})[1], 0x50);
    EXPECT_EQ(f.command({0xDD, 0}), Accepted);
    f.tick(3);
    EXPECT_TRUE(f.received().empty());
    EXPECT_EQ(f.command({0xE2, 0, 0, 0, 0, 0}), Accepted);
}

TEST(XcpDaq, writesSeveralEntriesWithOneCommand) {
    BoardFixture f;
    f.connect();
    f.command({0xD6});
    f.command({0xD5, 0, 1, 0});
    f.command({0xD4, 0, 0, 0, 1});
    f.command({0xD3, 0, 0, 0, 0, 2});
    f.command({0xE2, 0, 0, 0, 0, 0});
    EXPECT_EQ(f.command({0xC7, 2, 0xFF, 4, 0, 0, 0, 0, 0, 0, 0xFF, 4, 48, 0, 0, 0, 0, 0}), Accepted);
    EXPECT_EQ(f.command({0xC7, 2, 0xFF, 4, 0, 0, 0, 0, 0, 0}), refused(0x21));
    EXPECT_EQ(f.command({0xDE, 1, 0, 0}), (Octets{0xFF, 0}));
    f.tick();
    EXPECT_EQ(f.received().at(0).size(), 1U + 4 + 4);
}

TEST(XcpDaq, dropsWholeSamplesCountsThemAndSaysSoOnce) {
    BoardFixture f;
    f.connect();
    startList(f, {{{0, 4}}, {{8, 4}}}, 0);
    f.tick(5000); // 5000 samples of 22 octets in the queue: far more than it holds
    std::uint8_t buffer[HB_MAX_DTO];
    std::uint16_t counter = hb_board_counter(&f.board().board);
    int samples = 0;
    int overloads = 0;
    while (const std::uint16_t length = hb_board_transmit(&f.board().board, buffer, sizeof buffer)) {
        const bool is_event = buffer[0] == 0xFD;
        // The event stands where the first sample, two messages, is missing.
        ASSERT_EQ(hb_board_counter(&f.board().board),
                  static_cast<std::uint16_t>(counter + (is_event ? 3 : 1)));
        counter = hb_board_counter(&f.board().board);
        if (is_event) {
            EXPECT_EQ(buffer[1], 0x06);
            ++overloads;
            continue;
        }
        ASSERT_EQ(buffer[0], samples % 2 == 0 ? 0 : 1) << "a sample is whole";
        ASSERT_EQ(length, samples % 2 == 0 ? 9 : 5);
        ++samples;
    }
    EXPECT_EQ(overloads, 1);
    EXPECT_EQ(samples % 2, 0);
    f.tick();
    const int kept = samples / 2;
    ASSERT_GT(hb_board_transmit(&f.board().board, buffer, sizeof buffer), 0);
    // Two messages for every sample dropped after the first.
    EXPECT_EQ(static_cast<std::uint16_t>(hb_board_counter(&f.board().board) - counter),
              static_cast<std::uint16_t>(2 * (5000 - kept - 1) + 1));
    EXPECT_GT(kept, 1000);
}

} // namespace
} // namespace halbench::devices::firmware
