#include "tests/devices/firmware/board_fixture.h"

#include <gtest/gtest.h>

namespace halbench::devices::firmware {
namespace {

// Numbers of starts, resources/help/protocol.md 3.15.

constexpr double Step_rad = 0.5;

BoardFixture& readyToStep(BoardFixture& f) {
    f.driveIn(HB_MODE_POSITION);
    f.writePaged(offsetof(hb_htm_calibration, stray_enabled), 0.0F); // this rotor's coils have no stray field
    f.writeLive(offsetof(hb_htm_live, reference.shape), {HB_SHAPE_STEP});
    f.writeLive(offsetof(hb_htm_live, reference.amplitude), f.octetsOf(static_cast<float>(Step_rad)));
    f.writeLive(offsetof(hb_htm_live, reference.duration_s), f.octetsOf(0.05F));
    f.tick(20);
    return f;
}

Octets start(BoardFixture& f, int order) {
    return f.writeLive(offsetof(hb_htm_live, board.reference_start), {static_cast<std::uint8_t>(order)});
}

/// Steps that the reference has made since it stood at the rotor.
double stepsOf(BoardFixture& f) {
    return (static_cast<double>(f.board().signals.reference) - f.angle_rad) / Step_rad;
}

TEST(StartOrders, aRepeatedNumberStartsNothingWhenever) {
    for (const int later : {0, 1, 9, 10, 30, 100}) { // pending, running, over
        BoardFixture f;
        readyToStep(f);
        EXPECT_EQ(start(f, 7), Accepted);
        f.tick(later);
        EXPECT_EQ(start(f, 7), Accepted);
        f.tick(100);
        EXPECT_NEAR(stepsOf(f), 1.0, 1e-6) << later;
        EXPECT_EQ(f.board().live.board.reference_start, 0) << "shows what runs, not the number";
    }
}

TEST(StartOrders, anotherNumberStartsAndOneAlwaysDoes) {
    BoardFixture f;
    readyToStep(f);
    int steps = 0;
    for (const int order : {2, 3, 255, 2, 1, 1, 2}) {
        EXPECT_EQ(start(f, order), Accepted);
        f.tick(70);
        EXPECT_NEAR(stepsOf(f), ++steps, 1e-5);
    }
}

TEST(StartOrders, aStopIsNoNumber) {
    BoardFixture f;
    readyToStep(f);
    start(f, 9);
    start(f, 0); // before its time came
    f.tick(70);
    EXPECT_NEAR(stepsOf(f), 0.0, 1e-6);
    start(f, 9); // late, from the line
    f.tick(70);
    EXPECT_NEAR(stepsOf(f), 0.0, 1e-6);
}

TEST(StartOrders, aNewMasterCountsAnew) {
    BoardFixture f;
    readyToStep(f);
    start(f, 2);
    f.tick(100);
    f.connect();
    readyToStep(f);
    start(f, 2);
    f.tick(100);
    EXPECT_NEAR(stepsOf(f), 1.0, 1e-6);
}

TEST(StartOrders, holdForTheCaptureToo) {
    BoardFixture f;
    f.tick();
    f.connect();
    const auto capture = [&f](int order) {
        EXPECT_EQ(f.writeLive(offsetof(hb_htm_live, capture.start), {static_cast<std::uint8_t>(order)}),
                  Accepted);
    };
    capture(2);
    f.tick(10);
    const std::uint32_t began_us = f.board().signals.board.capture_time_us;
    capture(2);
    EXPECT_EQ(f.board().live.capture.start, 1);
    f.tick(10);
    EXPECT_EQ(f.board().signals.board.capture_time_us, began_us);
    f.tick(HB_CAPTURE_SAMPLES);
    EXPECT_EQ(f.board().signals.board.capture_state, HB_CAPTURE_FULL);
    capture(2);
    EXPECT_EQ(f.board().live.capture.start, 0);
    f.tick();
    EXPECT_EQ(f.board().signals.board.capture_state, HB_CAPTURE_FULL) << "what was captured stays";
    capture(3);
    f.tick();
    EXPECT_EQ(f.board().signals.board.capture_state, HB_CAPTURE_RUNNING);
    f.connect();
    capture(3);
    f.tick(2);
    EXPECT_GT(f.board().signals.board.capture_time_us, began_us);
}

} // namespace
} // namespace halbench::devices::firmware
