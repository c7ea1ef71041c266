#include "tests/devices/firmware/board_fixture.h"

#include <gtest/gtest.h>

namespace halbench::devices::firmware {
namespace {

// How soon a motion ends, by order or without a master (resources/help/protocol.md 3.11, 3.15, gate 3).

void driveWith(BoardFixture& f, float current_A) {
    f.driveIn(HB_MODE_CURRENT);
    f.setSetpoint(current_A);
    f.tick();
    ASSERT_FALSE(f.isOutputZero());
}

TEST(EndOfMotion, theTickAfterAStopArrivesPutsOutNothing) {
    // Gate 3 of resources/help/protocol.md: one control cycle, whatever phase the position loop is in.
    const auto startSine = [](BoardFixture& f) {
        f.writeLive(offsetof(hb_htm_live, reference.shape), {HB_SHAPE_SINE});
        f.writeLive(offsetof(hb_htm_live, reference.amplitude), f.octetsOf(0.3F));
        f.writeLive(offsetof(hb_htm_live, board.reference_start), {1});
    };
    const Octets byCommand{0xF1, 0x45};
    const Octets byParameter{0xED, 1, 0, 0, offsetof(hb_htm_live, board.stop), 0x80, 0, 0, 1};
    for (const std::uint8_t mode : {HB_MODE_CURRENT, HB_MODE_POSITION, HB_MODE_D_AXIS}) {
        for (const Octets& stop : {byCommand, byParameter}) {
            for (int phase = 0; phase < 10; ++phase) {
                BoardFixture f;
                f.driveIn(mode);
                f.setSetpoint(0.5F);
                startSine(f);
                f.tick(30 + phase);
                ASSERT_FALSE(f.isOutputZero());
                f.send(stop);
                f.tick();
                ASSERT_TRUE(f.isOutputZero()) << int{mode} << " " << phase;
                ASSERT_EQ(f.outputs.current_command_A, 0.0F);
                ASSERT_EQ(f.board().signals.current_command_A, 0.0F);
                ASSERT_EQ(f.board().signals.board.status, HB_STATUS_STOPPED);
            }
        }
    }
}

TEST(EndOfMotion, theWatchdogCannotBeTakenAwayWhileArmed) {
    BoardFixture f;
    driveWith(f, 2.0F);
    EXPECT_EQ(f.writeLive(offsetof(hb_htm_live, board.watchdog_ms), {44, 1}), Accepted);
    EXPECT_EQ(f.writeLive(offsetof(hb_htm_live, board.watchdog_ms), {0, 0}), refused(0x22));
    // 300 = 0x012C: octet by octet, and together with an order to arm
    EXPECT_EQ(f.writeLive(offsetof(hb_htm_live, board.watchdog_ms) + 1, {0}), Accepted) << "0x002C is 44 ms";
    EXPECT_EQ(f.writeLive(offsetof(hb_htm_live, board.watchdog_ms), {0}), refused(0x22));
    EXPECT_EQ(f.writeLive(offsetof(hb_htm_live, board.watchdog_ms), {0, 0, 1}), refused(0x22));
    EXPECT_EQ(f.board().live.board.watchdog_ms, 44);
    f.tick(44);
    EXPECT_TRUE(f.isOutputZero());
    EXPECT_EQ(f.board().signals.board.status, HB_STATUS_WATCHDOG);
}

TEST(EndOfMotion, theWatchdogIsNeverLongerThanTwoSeconds) {
    BoardFixture f;
    driveWith(f, 2.0F);
    EXPECT_EQ(f.writeLive(offsetof(hb_htm_live, board.watchdog_ms), {0x60, 0xEA}), Accepted); // 60000 ms
    EXPECT_EQ(f.board().live.board.watchdog_ms, 2000);
    EXPECT_EQ(f.writeLive(offsetof(hb_htm_live, board.watchdog_ms) + 1, {0xFF}), Accepted);
    EXPECT_EQ(f.board().live.board.watchdog_ms, 2000);
    f.command({0xFE}); // and the master is gone
    f.tick(1999);
    EXPECT_FALSE(f.isOutputZero());
    f.tick();
    EXPECT_TRUE(f.isOutputZero());
}

TEST(EndOfMotion, aWatchdogSetToNothingBeforeArmingBecomesASecond) {
    BoardFixture f;
    f.tick();
    f.connect();
    // both in one command: the board arms with what it is given
    EXPECT_EQ(f.writeLive(offsetof(hb_htm_live, board.watchdog_ms), {0, 0, 1}), Accepted);
    f.tick();
    EXPECT_EQ(f.board().signals.board.status, HB_STATUS_ARMED);
    EXPECT_EQ(f.board().live.board.watchdog_ms, 1000);
}

} // namespace
} // namespace halbench::devices::firmware
