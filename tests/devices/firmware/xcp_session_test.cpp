#include "tests/devices/firmware/board_fixture.h"

#include <gtest/gtest.h>

namespace halbench::devices::firmware {
namespace {

// Octets below are written from resources/help/protocol.md 3.5, 3.6 and 3.11, not from the slave.

TEST(XcpSession, answersConnectWithItsSizesAndResources) {
    BoardFixture f;
    EXPECT_EQ(f.command({0xFF, 0x00}), (Octets{0xFF, 0x05, 0xC0, 255, 0xFC, 0x01, 1, 1}));
}

TEST(XcpSession, ignoresEverythingButConnectBeforeTheSessionStarts) {
    BoardFixture f;
    for (int code = 0; code < 0xFF; ++code) {
        f.send({static_cast<std::uint8_t>(code), 0, 0, 0, 0, 0, 0, 0});
    }
    f.send({0xFF, 0x01}); // user-defined connect mode is not ours
    EXPECT_TRUE(f.received().empty());
    EXPECT_EQ(f.command({0xFF, 0x00}).size(), 8U);
}

TEST(XcpSession, endsWithDisconnect) {
    BoardFixture f;
    f.connect();
    EXPECT_EQ(f.command({0xFE}), Accepted);
    EXPECT_TRUE(f.command({0xFD}).empty());
}

TEST(XcpSession, answersStatusSynchAndModeInfo) {
    BoardFixture f;
    f.connect();
    EXPECT_EQ(f.command({0xFD}), (Octets{0xFF, 0, 0, 0, 0, 0}));
    EXPECT_EQ(f.command({0xFC}), refused(0x00));
    EXPECT_EQ(f.command({0xFB}).size(), 8U);
    EXPECT_EQ(f.command({0xC0, 0x00}), (Octets{0xFF, 0, 1, 4, 1, 4}));
}

TEST(XcpSession, namesUnknownAndShortCommands) {
    BoardFixture f;
    f.connect();
    EXPECT_EQ(f.command({0xCC}), refused(0x20));
    EXPECT_EQ(f.command({0xF8, 0, 1}), refused(0x20)); // seed and key are not implemented
    EXPECT_EQ(f.command({0xF1, 0x01}), refused(0x20)); // stays free for the Vector extension
    const std::pair<std::uint8_t, std::size_t> minimum[] = {
        {0xFA, 2}, {0xF9, 4}, {0xF6, 8}, {0xF5, 2}, {0xF4, 8}, {0xF3, 8}, {0xF1, 2}, {0xF0, 2}, {0xED, 8},
        {0xEB, 4}, {0xEA, 3}, {0xE8, 5}, {0xE7, 4}, {0xE4, 5}, {0xE2, 6}, {0xE1, 8}, {0xE0, 8}, {0xDF, 4},
        {0xDE, 4}, {0xDD, 2}, {0xD7, 4}, {0xD5, 4}, {0xD4, 5}, {0xD3, 6}, {0xC7, 2}, {0xC0, 2}};
    for (const auto& [code, length] : minimum) {
        Octets packet(length - 1, 0);
        packet[0] = code;
        EXPECT_EQ(f.command(packet), refused(0x21)) << std::hex << int(code);
    }
}

TEST(XcpSession, ignoresEmptyAndOverlongPackets) {
    BoardFixture f;
    f.connect();
    f.send({});
    f.send(Octets(256, 0xFD));
    EXPECT_TRUE(f.received().empty());
}

TEST(XcpSession, identifiesItself) {
    hb_htm_config config{};
    config.device = "sim-htm-1";
    config.variant = "-sim";
    BoardFixture f(&config);
    f.connect();
    const Octets text = f.command({0xFA, 0});
    EXPECT_EQ(std::string(text.begin() + 8, text.end()), "sim-htm-1");
    EXPECT_EQ(text[1], 1); // the text is in the answer
    const Octets model = f.command({0xFA, 1});
    EXPECT_EQ(std::string(model.begin() + 8, model.end()), "htm");
    const Octets epk = f.command({0xFA, 5});
    const std::string epk_text(epk.begin() + 8, epk.end());
    EXPECT_EQ(epk_text.substr(0, 8), "0.3.0-0x");
    EXPECT_EQ(epk_text.substr(epk_text.size() - 4), "-sim");
    const Octets path = f.command({0xFA, 2});
    EXPECT_EQ(BoardFixture::u32(path, 4), 0U);
    EXPECT_EQ(f.command({0xFA, 99}), refused(0x22));
}

TEST(XcpSession, changesTheEpkWhenATableChanges) {
    const auto epkWith = [](const hb_signal* extra) {
        hb_htm_config config{};
        config.extra.entries = extra;
        config.extra.count = extra ? 1 : 0;
        BoardFixture f(&config);
        f.connect();
        return f.command({0xFA, 5});
    };
    const hb_signal one = truthSignal();
    hb_signal two = one;
    two.entry.upper = 1.0F;
    EXPECT_NE(epkWith(nullptr), epkWith(&one));
    EXPECT_NE(epkWith(&one), epkWith(&two));
    EXPECT_EQ(epkWith(&one), epkWith(&one));
}

TEST(XcpSession, restartsOnConnectAndClearsTheMeasurement) {
    BoardFixture f;
    f.connect();
    f.command({0xD6});
    f.command({0xD5, 0, 1, 0});
    f.connect();
    EXPECT_EQ(f.command({0xD4, 0, 0, 0, 1}), refused(0x29)); // nothing is allocated any more
}

TEST(XcpSession, obeysStopWithoutASessionAndStaysSilent) {
    BoardFixture f;
    f.tick();
    f.send({0xF1, 0x45});
    EXPECT_TRUE(f.received().empty());
    f.tick();
    EXPECT_EQ(f.board().signals.board.status, HB_STATUS_STOPPED);
    f.send({0xF1, 0x52}); // the reset needs a session
    f.tick();
    EXPECT_EQ(f.board().signals.board.status, HB_STATUS_STOPPED);
}

TEST(XcpSession, ordersAnswersAfterAStopInTheMiddle) {
    BoardFixture f;
    f.connect();
    f.send({0xFD});
    f.send({0xF1, 0x45});
    const std::vector<Octets> answers = f.received();
    ASSERT_EQ(answers.size(), 2U);
    EXPECT_EQ(answers[0].size(), 6U);
    EXPECT_EQ(answers[1], (Octets{0xFF, HB_LATCH_COMMAND}));
}

TEST(XcpSession, countsMessagesWithoutGaps) {
    BoardFixture f;
    std::uint8_t buffer[HB_MAX_DTO];
    std::uint16_t previous = 0;
    f.send({0xFF, 0x00});
    ASSERT_GT(hb_board_transmit(&f.board().board, buffer, sizeof buffer), 0);
    previous = hb_board_counter(&f.board().board);
    for (int i = 0; i < 70000; ++i) { // past the turn of the 16 bit counter
        f.send({0xFD});
        ASSERT_EQ(hb_board_transmit(&f.board().board, buffer, sizeof buffer), 6);
        ASSERT_EQ(hb_board_counter(&f.board().board), static_cast<std::uint16_t>(previous + 1));
        previous = hb_board_counter(&f.board().board);
    }
}

} // namespace
} // namespace halbench::devices::firmware
