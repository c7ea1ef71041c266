#include "devices/open/sxi_framing.h"
#include "tests/devices/firmware/avr/avr_fixture.h"

#include <gtest/gtest.h>

namespace halbench::simavr {
namespace {

using devices::BoardMode;

/// Somebody presses the board's reset button, and a master connects anew.
void pressReset(AvrBench& bench) {
    bench.board->core().reset();
    bench.device.reset(); // its farewell reaches nobody
    bench.board->advanceTo(bench.board->time_s() + 0.05);
    bench = connect(bench.board);
}

void sendCommand(AvrBoard& board, std::uint8_t counter, const std::vector<std::uint8_t>& command) {
    std::vector<std::uint8_t> line;
    devices::SxiFraming framing;
    framing.append(line, counter, command);
    board.core().send(line);
}

const std::vector<std::uint8_t> Save{0xF9, 0x01, 0x00, 0x00};
const std::vector<std::uint8_t> Stop{0xF1, 0x45};

TEST(AvrStore, aSavedCalibrationIsThereAfterAResetAndAnUnsavedOneIsNot) {
    const auto board = makeBoard(perfectMotor());
    AvrBench bench = connect(board);
    ASSERT_TRUE(bench.device);
    for (const double gain : {12.5, 17.0, 3.0}) { // both slots, and the first one again
        ASSERT_TRUE(bench.write("gain.kp", gain));
        const auto saved = bench.device->saveParameters();
        ASSERT_TRUE(saved) << saved.error().message;
        ASSERT_TRUE(bench.write("gain.kp", 99.0));
        pressReset(bench);
        ASSERT_TRUE(bench.device);
        EXPECT_EQ(bench.read("gain.kp"), gain);
        EXPECT_NEAR(bench.read("gain.ki"), 0.1, 1e-8); // a float
    }
}

TEST(AvrStore, aSaveThatIsCutOffLeavesTheOneBefore) {
    const auto board = makeBoard(perfectMotor());
    AvrBench bench = connect(board);
    ASSERT_TRUE(bench.device);
    ASSERT_TRUE(bench.write("gain.kp", 12.5));
    ASSERT_TRUE(bench.device->saveParameters());
    for (const double cut_s : {0.01, 0.1, 0.2, 0.4}) { // of the 0.42 s that 123 octets take
        ASSERT_TRUE(bench.write("gain.kp", 40.0));
        sendCommand(*board, 0, Save);
        board->advanceTo(board->time_s() + cut_s);
        pressReset(bench);
        ASSERT_TRUE(bench.device);
        EXPECT_EQ(bench.read("gain.kp"), 12.5) << cut_s;
    }
}

TEST(AvrStore, aStopActsWithinTwentyMillisecondsWhileTheBoardSaves) {
    const auto board = makeBoard(perfectMotor());
    AvrBench bench = connect(board);
    ASSERT_TRUE(bench.device);
    ASSERT_TRUE(bench.write("hb.mode", static_cast<double>(BoardMode::Current)));
    ASSERT_TRUE(bench.device->arm());
    ASSERT_TRUE(bench.write("hb.setpoint", 3.0));
    bench.wait(0.3);
    ASSERT_NE(board->dacCode(0), 2048);
    sendCommand(*board, 0, Save);
    board->advanceTo(board->time_s() + 0.1);
    sendCommand(*board, 1, Stop);
    board->advanceTo(board->time_s() + 0.020); // resources/help/protocol.md, gate 3
    EXPECT_EQ(board->dacCode(0), 2048);
    EXPECT_EQ(board->dacCode(1), 2048);
    // What the deepest call so far left of the stack: an interrupt more needs 30 octets.
    EXPECT_GE(board->core().untouchedRam(), 48U);
}

} // namespace
} // namespace halbench::simavr
