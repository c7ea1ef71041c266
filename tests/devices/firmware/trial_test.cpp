#include "tests/devices/firmware/board_fixture.h"

#include <gtest/gtest.h>

#include <cstddef>

// hb.trial: resources/help/protocol.md 3.15.

namespace halbench::devices::firmware {
namespace {

constexpr float OldGain = 10.0F; // preset "published"
constexpr float NewGain = 40.0F;

class Trial : public ::testing::Test {
protected:
    void openTrial() {
        fixture.connect();
        fixture.tick();
        fixture.writeLive(offsetof(hb_htm_live, board.trial), {1});
    }

    /// The master's transaction: copy to the idle page, write there, switch.
    void writeNewGain() {
        const std::uint8_t running = fixture.board().board.xcp.next_page;
        const auto idle = static_cast<std::uint8_t>(1 - running);
        fixture.command({0xEB, 0x02, 0, idle});
        fixture.command({0xE4, 0, running, 0, idle});
        fixture.writePaged(offsetof(hb_htm_calibration, kp), NewGain);
        fixture.command({0xEB, 0x01, 0, idle});
    }

    float runningGain() {
        fixture.tick(2);
        return fixture.board().pages[fixture.board().board.xcp.active_page].kp;
    }

    float gainOnTheWire() {
        const Octets answer = fixture.read(0x10000U + offsetof(hb_htm_calibration, kp), 4);
        float value = 0.0F;
        std::memcpy(&value, answer.data() + 1, sizeof value);
        return value;
    }

    BoardFixture fixture;
};

TEST_F(Trial, silenceOfTheMasterBringsTheOldCalibrationBack) {
    openTrial();
    writeNewGain();
    EXPECT_EQ(runningGain(), NewGain);
    fixture.writeLive(offsetof(hb_htm_live, board.watchdog_ms), {200, 0});
    fixture.tick(250);
    EXPECT_EQ(runningGain(), OldGain);
    EXPECT_EQ(fixture.board().live.board.trial, 0);
    EXPECT_EQ(fixture.board().signals.board.torn_count, 0U);
}

TEST_F(Trial, survivesFurtherTransactions) {
    openTrial();
    writeNewGain();
    fixture.tick(2);
    writeNewGain(); // now no page holds the old gain
    fixture.tick(2);
    fixture.command({0xFE}); // DISCONNECT
    EXPECT_EQ(runningGain(), OldGain);
}

TEST_F(Trial, newConnectionFindsTheOldCalibrationEvenBeforeTheNextCycle) {
    openTrial();
    writeNewGain(); // ordered, not yet running
    fixture.connect();
    EXPECT_EQ(gainOnTheWire(), OldGain);
    EXPECT_EQ(runningGain(), OldGain);
}

TEST_F(Trial, closedTrialKeepsTheNewCalibration) {
    openTrial();
    writeNewGain();
    fixture.tick(2);
    fixture.writeLive(offsetof(hb_htm_live, board.trial), {0});
    fixture.connect();
    EXPECT_EQ(gainOnTheWire(), NewGain);
    EXPECT_EQ(runningGain(), NewGain);
}

TEST_F(Trial, withoutOneADisconnectChangesNothing) {
    fixture.connect();
    fixture.tick();
    writeNewGain();
    fixture.tick(2);
    fixture.command({0xFE});
    EXPECT_EQ(runningGain(), NewGain);
}

TEST_F(Trial, newMasterFindsTheBoardDisarmed) {
    fixture.connect();
    fixture.tick();
    fixture.writeLive(offsetof(hb_htm_live, board.mode), {HB_MODE_CURRENT});
    fixture.writeLive(offsetof(hb_htm_live, board.arm), {1});
    fixture.writeLive(offsetof(hb_htm_live, setpoint), BoardFixture::octetsOf(2.0F));
    fixture.tick();
    ASSERT_EQ(fixture.outputs.output_enabled, 1);
    fixture.connect();
    fixture.tick();
    EXPECT_EQ(fixture.outputs.output_enabled, 0);
    EXPECT_EQ(fixture.outputs.dac_code[0], 2048);
    EXPECT_EQ(fixture.board().live.board.arm, 0);
}

TEST_F(Trial, damagedConnectDisarmsNobody) {
    fixture.connect();
    fixture.tick();
    fixture.writeLive(offsetof(hb_htm_live, board.mode), {HB_MODE_CURRENT});
    fixture.writeLive(offsetof(hb_htm_live, board.arm), {1});
    fixture.command({0xFF, 0x77});
    fixture.tick();
    EXPECT_EQ(fixture.board().live.board.arm, 1);
}

} // namespace
} // namespace halbench::devices::firmware
