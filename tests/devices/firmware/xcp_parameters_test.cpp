#include "tests/devices/firmware/board_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace halbench::devices::firmware {
namespace {

constexpr std::uint32_t Segment = 0x10000;
constexpr std::uint32_t Live = 0x8000;
constexpr std::uint32_t PageOctets = sizeof(hb_htm_calibration);

std::uint32_t paged(std::size_t offset) {
    return Segment + static_cast<std::uint32_t>(offset);
}

/// CRC16-CCITT bit by bit, a second route beside the slave's byte-wise one.
std::uint16_t crcBitByBit(const Octets& octets) {
    std::uint16_t crc = 0xFFFF;
    for (const std::uint8_t octet : octets) {
        crc = static_cast<std::uint16_t>(crc ^ (octet << 8));
        for (int bit = 0; bit < 8; ++bit) {
            crc = static_cast<std::uint16_t>((crc & 0x8000) ? (crc << 1) ^ 0x1021 : crc << 1);
        }
    }
    return crc;
}

Octets readPage(BoardFixture& f) {
    Octets page;
    f.command({0xF6, 0, 0, 0, 0, 0, 1, 0}); // SET_MTA 0x10000
    while (page.size() <
           PageOctets) { // a page is longer than an answer may be; the address goes on by itself
        const std::size_t part = std::min<std::size_t>(PageOctets - page.size(), 200);
        const Octets answer = f.command({0xF5, static_cast<std::uint8_t>(part)});
        if (answer.size() != part + 1) {
            break;
        }
        page.insert(page.end(), answer.begin() + 1, answer.end());
    }
    return page;
}

TEST(XcpParameters, startWithThePublishedPreset) {
    BoardFixture f;
    f.connect();
    EXPECT_EQ(f.read(paged(offsetof(hb_htm_calibration, kp)), 4), (Octets{0xFF, 0, 0, 0x20, 0x41})); // 10.0F
    EXPECT_EQ(f.board().pages[0].ki, 0.1F);
    EXPECT_EQ(f.board().pages[0].kd, 0.0F);
    EXPECT_EQ(f.board().pages[0].stray_enabled, 1.0F);
    EXPECT_EQ(f.board().pages[0].stray_coefficient, 2.5e-3F);
    EXPECT_EQ(f.board().pages[0].hall_amplitude, 0.157F);
    EXPECT_EQ(f.board().pages[0].window_speed, 40.0F);
    EXPECT_EQ(f.board().pages[0].window_position_enabled, 0.0F);
}

TEST(XcpParameters, refusesWhatIsNotFinite) {
    BoardFixture f;
    f.tick();
    f.connect();
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::quiet_NaN(),
                            std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(),
                            std::numeric_limits<float>::signaling_NaN()}) {
        EXPECT_EQ(f.writePaged(offsetof(hb_htm_calibration, kp), bad), refused(0x22));
        EXPECT_EQ(f.writeLive(offsetof(hb_htm_live, setpoint), f.octetsOf(bad)), refused(0x22));
    }
    EXPECT_EQ(f.board().pages[0].kp, 10.0F);
    EXPECT_EQ(f.board().live.setpoint, 0.0F);
}

TEST(XcpParameters, takesNothingOfADownloadWithOneBadValue) {
    BoardFixture f;
    f.connect();
    f.command({0xF6, 0, 0, 0, 4, 0, 1, 0}); // SET_MTA gain.kp; kp, ki, kd follow each other
    Octets packet{0xF0, 12};
    for (const float value : {20.0F, 30.0F, std::numeric_limits<float>::quiet_NaN()}) {
        const Octets octets = BoardFixture::octetsOf(value);
        packet.insert(packet.end(), octets.begin(), octets.end());
    }
    ASSERT_EQ(offsetof(hb_htm_calibration, kp), 4U);
    EXPECT_EQ(f.command(packet), refused(0x22));
    EXPECT_EQ(f.board().pages[0].kp, 10.0F);
    EXPECT_EQ(f.board().pages[0].ki, 0.1F);
}

TEST(XcpParameters, clampsFiniteValuesToTheirLimits) {
    BoardFixture f;
    f.connect();
    EXPECT_EQ(f.writePaged(offsetof(hb_htm_calibration, limit_current), 7.0F), Accepted);
    EXPECT_EQ(f.board().pages[0].limit_current, 4.0F);
    EXPECT_EQ(f.writePaged(offsetof(hb_htm_calibration, limit_temperature), 200.0F), Accepted);
    EXPECT_EQ(f.board().pages[0].limit_temperature, 80.0F);
    EXPECT_EQ(f.writePaged(offsetof(hb_htm_calibration, kp), -1.0F), Accepted);
    EXPECT_EQ(f.board().pages[0].kp, 0.0F);
    EXPECT_EQ(f.writeLive(offsetof(hb_htm_live, board.mode), {9}), Accepted);
    EXPECT_EQ(f.board().live.board.mode, HB_MODE_D_AXIS);
}

// What belongs to nobody on the board, e.g. to the world that a simulation makes around it.
TEST(XcpParameters, servesTheCallersOwnParameters) {
    struct World {
        float pull_N = 2.0F;
        std::uint8_t season = 1;
        std::uint8_t hidden = 77;
    } world;
    const hb_parameter table[] = {
        HB_PARAM(HB_EXTRA, "world.pull", "N", HB_FLOAT32, World, pull_N, 0.0F, -5.0F, 5.0F, nullptr, "Pull"),
        HB_PARAM(HB_EXTRA, "world.season", "", HB_UBYTE, World, season, 0.0F, 0.0F, 3.0F, nullptr, "Season")};
    constexpr std::uint32_t Extra = 0xC000;
    hb_htm_config config{};
    config.extra_parameters = {table, reinterpret_cast<std::uint8_t*>(&world), 2, offsetof(World, hidden)};
    BoardFixture f(&config);
    f.connect();
    EXPECT_EQ(world.pull_N, 2.0F); // the caller's value, not the table's
    EXPECT_EQ(f.write(Extra, f.octetsOf(-3.0F)), Accepted);
    EXPECT_EQ(world.pull_N, -3.0F);
    EXPECT_EQ(f.write(Extra, f.octetsOf(9.0F)), Accepted);
    EXPECT_EQ(world.pull_N, 5.0F);
    EXPECT_EQ(f.write(Extra, f.octetsOf(std::numeric_limits<float>::quiet_NaN())), refused(0x22));
    EXPECT_EQ(f.write(Extra + 4, {200}), Accepted);
    EXPECT_EQ(world.season, 3);
    EXPECT_EQ(f.write(Extra + 5, {1}), refused(0x22));
    EXPECT_EQ(f.read(Extra + 4, 2), refused(0x22));
    EXPECT_EQ(world.hidden, 77);
    EXPECT_EQ(f.read(Extra + 4, 1).back(), 3);
    BoardFixture without;
    without.connect();
    EXPECT_EQ(without.write(Extra, {1}), refused(0x22));
    EXPECT_EQ(without.read(Extra, 1), refused(0x22));
}

TEST(XcpParameters, protectsSignalsAndEverythingOutsideTheTables) {
    BoardFixture f;
    f.connect();
    EXPECT_EQ(f.write(0, {1, 2, 3, 4}), refused(0x23));
    EXPECT_EQ(f.write(8U * 200, {1}), refused(0x22));
    EXPECT_EQ(f.read(8U * 200, 1), refused(0x22));
    EXPECT_EQ(f.read(Segment + PageOctets - 2, 4), refused(0x22));
    EXPECT_EQ(f.write(Segment + PageOctets, {1}), refused(0x22));
    EXPECT_EQ(f.read(Live + sizeof(hb_htm_live) + 1, 1), refused(0x22));
    EXPECT_EQ(f.read(0xFFFFFFF0, 32), refused(0x22));
    EXPECT_EQ(f.read(0, 4, 7), refused(0x22));            // no such address extension
    EXPECT_EQ(f.read(4 * 4096 * 4, 1, 2), refused(0x22)); // behind the captured samples
    EXPECT_EQ(f.command({0xF4, 0, 0, 0, 0, 0, 0, 0}), refused(0x22));
    EXPECT_EQ(f.command({0xED, 248, 0, 0, 0, 0, 1, 0}), refused(0x22));  // more than a packet holds
    EXPECT_EQ(f.command({0xED, 4, 0, 0, 0, 0, 1, 0, 1}), refused(0x21)); // fewer octets than said
    f.command({0xF6, 0, 0, 1, 0, 0, 0, 0});
    EXPECT_EQ(f.command({0xF0, 1, 0}), refused(0x23)); // the A2L is not writable
}

TEST(XcpParameters, movesTheTransferAddressWithEachTransfer) {
    BoardFixture f;
    f.connect();
    f.command({0xF6, 0, 0, 0, 4, 0, 1, 0});
    Octets packet{0xF0, 4};
    for (const float value : {20.0F, 30.0F}) {
        packet.resize(2);
        const Octets octets = BoardFixture::octetsOf(value);
        packet.insert(packet.end(), octets.begin(), octets.end());
        EXPECT_EQ(f.command(packet), Accepted);
    }
    EXPECT_EQ(f.board().pages[0].kp, 20.0F);
    EXPECT_EQ(f.board().pages[0].ki, 30.0F);
}

TEST(XcpParameters, sendsABlockInSeveralAnswers) {
    BoardFixture f;
    f.connect();
    f.command({0xF6, 0, 0, 2, 0, 0, 0, 0}); // the capture block is longer than one packet
    f.send({0xF5, 255});
    const std::vector<Octets> answers = f.received();
    ASSERT_EQ(answers.size(), 2U);
    EXPECT_EQ(answers[0].size(), 255U);
    EXPECT_EQ(answers[1].size(), 2U);
}

TEST(XcpParameters, buildsTheStandardChecksum) {
    // "123456789" gives 29B1 for CRC16 with polynomial 1021, start FFFF: the published check value.
    EXPECT_EQ(crcBitByBit({'1', '2', '3', '4', '5', '6', '7', '8', '9'}), 0x29B1);
    BoardFixture f;
    f.connect();
    const Octets page = readPage(f);
    ASSERT_EQ(page.size(), PageOctets);
    f.command({0xF6, 0, 0, 0, 0, 0, 1, 0});
    const Octets answer = f.command({0xF3, 0, 0, 0, static_cast<std::uint8_t>(PageOctets),
                                     static_cast<std::uint8_t>(PageOctets >> 8), 0, 0});
    ASSERT_EQ(answer.size(), 8U);
    EXPECT_EQ(answer[1], 8);
    EXPECT_EQ(BoardFixture::u32(answer, 4), crcBitByBit(page));
    f.command({0xF6, 0, 0, 0, 0, 0, 1, 0});
    EXPECT_EQ(f.command({0xF3, 0, 0, 0, 0, 0, 0, 0}), refused(0x22));
    EXPECT_EQ(f.command({0xF3, 0, 0, 0, 255, 255, 0, 0}), refused(0x22)); // reaches behind the page
}

TEST(XcpPages, areDescribed) {
    BoardFixture f;
    f.connect();
    EXPECT_EQ(f.command({0xE9}), (Octets{0xFF, 1, 0}));
    const Octets address = f.command({0xE8, 0, 0, 0, 0});
    EXPECT_EQ(BoardFixture::u32(address, 4), Segment);
    const Octets length = f.command({0xE8, 0, 0, 1, 0});
    EXPECT_EQ(BoardFixture::u32(length, 4), PageOctets);
    EXPECT_EQ(f.command({0xE8, 1, 0, 0, 0})[1], 2);
    EXPECT_EQ(f.command({0xE7, 0, 0, 1}), (Octets{0xFF, 0x3F, 0}));
}

TEST(XcpPages, refuseWhatDoesNotExist) {
    BoardFixture f;
    f.connect();
    EXPECT_EQ(f.command({0xEB, 0x00, 0, 0}), refused(0x27));
    EXPECT_EQ(f.command({0xEB, 0x01, 1, 0}), refused(0x28));
    EXPECT_EQ(f.command({0xEB, 0x01, 0, 2}), refused(0x26));
    EXPECT_EQ(f.command({0xEB, 0x83, 9, 1}), Accepted); // "all segments"
    EXPECT_EQ(f.command({0xEA, 0x03, 0}), refused(0x27));
    EXPECT_EQ(f.command({0xEA, 0x01, 1}), refused(0x28));
    EXPECT_EQ(f.command({0xE4, 1, 0, 0, 1}), refused(0x28));
    EXPECT_EQ(f.command({0xE4, 0, 2, 0, 1}), refused(0x26));
    EXPECT_EQ(f.command({0xE8, 0, 1, 0, 0}), refused(0x28));
    EXPECT_EQ(f.command({0xE8, 3, 0, 0, 0}), refused(0x27));
    EXPECT_EQ(f.command({0xE7, 0, 0, 2}), refused(0x26));
}

TEST(XcpPages, reportTheOrderedPageBeforeTheLoopTookIt) {
    BoardFixture f;
    f.connect();
    f.command({0xEB, 0x01, 0, 1});
    EXPECT_EQ(f.command({0xEA, 0x01, 0}), (Octets{0xFF, 0, 0, 1}));
    EXPECT_EQ(f.board().board.xcp.active_page, 0);
    f.tick();
    EXPECT_EQ(f.board().board.xcp.active_page, 1);
}

TEST(XcpPages, areNeverCopiedUnderTheRunningLoop) {
    BoardFixture f;
    f.tick();
    f.connect();
    EXPECT_EQ(f.command({0xE4, 0, 1, 0, 0}), refused(0x23));
    EXPECT_EQ(f.command({0xE4, 0, 0, 0, 1}), Accepted);
    f.command({0xEB, 0x01, 0, 1}); // page 1 is ordered, page 0 still runs: both are taboo
    EXPECT_EQ(f.command({0xE4, 0, 1, 0, 0}), refused(0x23));
    EXPECT_EQ(f.command({0xE4, 0, 0, 0, 1}), refused(0x23));
}

TEST(XcpPages, doNotBecomeActiveWithAHalfWrittenValue) {
    BoardFixture f;
    f.tick();
    f.connect();
    f.command({0xEB, 0x02, 0, 1});
    const std::uint32_t kp = paged(offsetof(hb_htm_calibration, kp));
    f.writePaged(offsetof(hb_htm_calibration, kp), 2000.0F); // 44FA0000
    // A tool may cut a download anywhere, so the idle page takes three octets of a value: 44FF0000 = 2040,
    // above the limit.
    EXPECT_EQ(f.write(kp, {0, 0, 0xFF}), Accepted);
    EXPECT_EQ(f.command({0xEB, 0x01, 0, 1}), refused(0x22));
    EXPECT_EQ(f.write(kp + 3, {0x7F}), refused(0x22)); // 7FFF0000 is a NaN
    EXPECT_EQ(f.write(kp + 3, {0x41}), Accepted);      // 41FF0000 = 31.875
    EXPECT_EQ(f.command({0xEB, 0x01, 0, 1}), Accepted);
    EXPECT_EQ(f.board().pages[1].kp, 31.875F);
}

TEST(XcpPages, refuseHalfAValueThatActsAtOnce) {
    BoardFixture f;
    f.tick();
    f.connect();
    const std::uint32_t kp = paged(offsetof(hb_htm_calibration, kp));
    f.writePaged(offsetof(hb_htm_calibration, kp), 2000.0F);
    EXPECT_EQ(f.write(kp, {0, 0, 0xFF}), refused(0x22));
    EXPECT_EQ(f.board().pages[0].kp, 2000.0F);
}

/// resources/help/protocol.md 3.10: copy, write a new set with its marks, switch; `gain` in every value.
void switchToNewSet(BoardFixture& f, std::uint32_t mark, float gain) {
    const std::uint8_t active = f.command({0xEA, 0x01, 0})[3];
    const auto idle = static_cast<std::uint8_t>(1 - active);
    ASSERT_EQ(f.command({0xEB, 0x02, 0, idle}), Accepted);
    ASSERT_EQ(f.command({0xE4, 0, active, 0, idle}), Accepted);
    f.write(paged(offsetof(hb_htm_calibration, set_first)), f.le32(mark));
    f.tick(); // the loop runs between any two commands
    f.writePaged(offsetof(hb_htm_calibration, kp), gain);
    f.tick();
    f.writePaged(offsetof(hb_htm_calibration, ki), gain);
    f.tick();
    f.write(paged(offsetof(hb_htm_calibration, set_last)), f.le32(mark));
    f.tick();
    ASSERT_EQ(f.command({0xEB, 0x01, 0, idle}), Accepted);
    f.tick();
}

TEST(XcpPages, neverMixASetInAThousandSwitches) {
    BoardFixture f;
    f.tick();
    f.connect();
    for (std::uint32_t i = 1; i <= 1000; ++i) {
        switchToNewSet(f, i, static_cast<float>(i));
        const hb_htm_calibration& running = f.board().pages[f.board().board.xcp.active_page];
        ASSERT_EQ(running.kp, static_cast<float>(i));
        ASSERT_EQ(running.ki, static_cast<float>(i));
    }
    EXPECT_EQ(f.board().signals.board.torn_count, 0U);
}

TEST(XcpPages, countACycleThatSawALiveWriteInTheMiddle) {
    BoardFixture f;
    f.tick();
    f.connect();
    f.write(paged(offsetof(hb_htm_calibration, set_first)), f.le32(7));
    f.tick(3);
    f.write(paged(offsetof(hb_htm_calibration, set_last)), f.le32(7));
    f.tick(3);
    EXPECT_EQ(f.board().signals.board.torn_count, 3U);
}

TEST(XcpPages, areStoredThroughTheCallbackOnly) {
    BoardFixture without;
    without.connect();
    EXPECT_EQ(without.command({0xF9, 1, 0, 0}), refused(0x24));

    hb_htm_calibration stored{};
    hb_htm_config config{};
    config.store_context = &stored;
    config.store = [](void* context, const void* page) -> std::uint8_t {
        *static_cast<hb_htm_calibration*>(context) = *static_cast<const hb_htm_calibration*>(page);
        return 1;
    };
    BoardFixture f(&config);
    f.connect();
    f.writePaged(offsetof(hb_htm_calibration, kp), 33.0F);
    f.send({0xF9, 1, 0, 0});
    EXPECT_EQ(f.received(), (std::vector<Octets>{{0xFF}, {0xFD, 0x03}}));
    EXPECT_EQ(stored.kp, 33.0F);
    EXPECT_EQ(f.command({0xF9, 2, 0, 0}), refused(0x27));

    hb_htm_config restarted{};
    restarted.stored = &stored;
    EXPECT_EQ(BoardFixture(&restarted).board().pages[1].kp, 33.0F);
    stored.ki = std::numeric_limits<float>::quiet_NaN(); // damaged memory: all defaults
    EXPECT_EQ(BoardFixture(&restarted).board().pages[0].kp, 10.0F);
}

} // namespace
} // namespace halbench::devices::firmware
