#include "tests/devices/firmware/avr/avr_fixture.h"

#include <gtest/gtest.h>

namespace halbench::simavr {
namespace {

using devices::BoardMode;

void turn(AvrBench& bench) {
    ASSERT_TRUE(bench.write("hb.mode", static_cast<double>(BoardMode::Current)));
    ASSERT_TRUE(bench.device->arm());
    ASSERT_TRUE(bench.write("hb.setpoint", 3.0));
    bench.wait(0.3);
    ASSERT_NE(bench.board->dacCode(0), 2048);
}

/// A fault ends the waiting early, with an error that says so.
void letPass(AvrBench& bench, double time_s) {
    (void)bench.device->clock().waitFor(time_s);
}

void expectFault(AvrBench& bench, const std::string& words) {
    EXPECT_NE(bench.device->state().faultText.find(words), std::string::npos)
        << bench.device->state().faultText;
    EXPECT_FALSE(bench.device->state().isArmed);
    EXPECT_FALSE(bench.device->arm()); // latched
}

TEST(AvrSafety, aConverterThatFallsOffTheBusIsALatchedFaultAndTheOtherGoesToZero) {
    for (const int missing : {0, 1}) {
        AvrBench bench = openBench();
        ASSERT_TRUE(bench.device);
        turn(bench);
        bench.board->connectDac(missing, false);
        letPass(bench, 0.1);
        expectFault(bench, "output converter");
        EXPECT_EQ(bench.board->dacCode(1 - missing), 2048);
        (void)bench.device->clearStop(); // the next tick latches it again
        letPass(bench, 0.1);
        expectFault(bench, "output converter");
        bench.board->connectDac(missing, true);
        ASSERT_TRUE(bench.device->clearStop());
        letPass(bench, 0.1);
        EXPECT_EQ(bench.board->dacCode(missing), 2048);
        EXPECT_TRUE(bench.device->arm());
    }
}

TEST(AvrSafety, aBrokenHallWireIsALatchedFault) {
    AvrBench bench = openBench();
    ASSERT_TRUE(bench.device);
    turn(bench);
    bench.board->breakChannel(0, 0);
    letPass(bench, 0.1);
    expectFault(bench, "sensor out of range");
    EXPECT_EQ(bench.board->dacCode(0), 2048);
    EXPECT_EQ(bench.board->dacCode(1), 2048);
}

TEST(AvrSafety, aHotCoilIsALatchedFault) {
    AvrBench bench = openBench();
    ASSERT_TRUE(bench.device);
    turn(bench);
    bench.board->breakChannel(3, 270); // (270 + 1/2) 5 V/1024 100 K/V - 50 = 82 degC
    letPass(bench, 0.1);
    expectFault(bench, "temperature");
    EXPECT_EQ(bench.board->dacCode(1), 2048);
}

TEST(AvrSafety, theWatchdogStopsWithinOneControlCycleOfItsTime) {
    AvrBench bench = openBench();
    ASSERT_TRUE(bench.device);
    turn(bench);
    ASSERT_TRUE(bench.write("hb.watchdog_ms", 300.0));
    const double written_s = bench.board->time_s();
    while (bench.board->dacCode(0) != 2048 || bench.board->dacCode(1) != 2048) {
        bench.board->advanceTo(bench.board->time_s() + 1e-4);
        ASSERT_LT(bench.board->time_s() - written_s, 1.0);
    }
    const double silence_s = bench.board->time_s() - written_s;
    // The answer to the write takes 1.5 ms to the master; one tick, and the time until both converters have
    // it.
    EXPECT_NEAR(silence_s, 0.300, 5e-3);
}

TEST(AvrSafety, aStopActsWithinTwentyMillisecondsWhileAnotherCommandIsPending) {
    using Command = std::vector<std::uint8_t>;
    // The longest commands there are, and the stop right behind them: a checksum over the page and over 16 kB
    // of description, an upload of 255 octets of it, its length.
    const std::vector<std::vector<Command>> pending = {
        {{0xF6, 0, 0, 0, 0, 0, 1, 0}, {0xF3, 0, 0, 0, 100, 0, 0, 0}},
        {{0xF6, 0, 0, 1, 0, 0, 0, 0}, {0xF3, 0, 0, 0, 0, 0x3F, 0, 0}},
        {{0xF6, 0, 0, 1, 0, 0, 0, 0}, {0xF5, 255}},
        {{0xFA, 4}}};
    for (std::size_t i = 0; i < pending.size(); ++i) {
        const auto board = makeBoard(perfectMotor());
        AvrBench bench = connect(board);
        ASSERT_TRUE(bench.device);
        turn(bench);
        const double sent_s = board->time_s();
        std::vector<std::uint8_t> line;
        devices::SxiFraming framing;
        std::uint8_t counter = 0;
        for (const Command& command : pending[i]) {
            framing.append(line, counter++, command);
        }
        framing.append(line, counter, Command{0xF1, 0x45});
        board->core().send(line);
        while (board->dacCode(0) != 2048 || board->dacCode(1) != 2048) {
            board->advanceTo(board->time_s() + 1e-4);
            ASSERT_LT(board->time_s() - sent_s, 0.1) << i;
        }
        EXPECT_LT(board->time_s() - sent_s, 0.020) << i; // resources/help/protocol.md, gate 3
    }
}

TEST(AvrSafety, aResetInTheMiddleOfAMotionEndsIt) {
    const auto board = makeBoard(perfectMotor());
    AvrBench bench = connect(board);
    ASSERT_TRUE(bench.device);
    turn(bench);
    board->core().reset(); // a brown-out, or somebody opens the port of an Arduino
    board->advanceTo(board->time_s() + 0.02);
    EXPECT_EQ(board->dacCode(0), 2048);
    EXPECT_EQ(board->dacCode(1), 2048);
    AvrBench again = connect(board);
    ASSERT_TRUE(again.device);
    EXPECT_FALSE(again.device->state().isArmed);
    EXPECT_EQ(again.read("hb.setpoint"), 0.0);
}

} // namespace
} // namespace halbench::simavr
