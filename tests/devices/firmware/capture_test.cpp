#include "devices/firmware/control/hb_capture.h"
#include "tests/devices/firmware/board_fixture.h"

#include <gtest/gtest.h>

namespace halbench::devices::firmware {
namespace {

constexpr std::uint8_t PositionHandle = 0, CommandHandle = 3, ReferenceHandle = 2;

void configure(BoardFixture& f, std::uint8_t trigger, std::uint16_t pretrigger) {
    f.writeLive(offsetof(hb_htm_live, capture.config.signal), {PositionHandle, CommandHandle});
    f.writeLive(offsetof(hb_htm_live, capture.config.trigger), {trigger});
    f.writeLive(offsetof(hb_htm_live, capture.config.trigger_signal), {CommandHandle});
    f.writeLive(offsetof(hb_htm_live, capture.config.pretrigger),
                {static_cast<std::uint8_t>(pretrigger), static_cast<std::uint8_t>(pretrigger >> 8)});
}

void start(BoardFixture& f) {
    f.writeLive(offsetof(hb_htm_live, capture.start), {1});
}

float sampleOverTheWire(BoardFixture& f, std::uint32_t channel, std::uint32_t index) {
    const Octets answer = f.read((channel * HB_CAPTURE_SAMPLES + index) * 4, 4, 2);
    const std::uint32_t bits = BoardFixture::u32(answer, 1);
    float value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

/// Turns the rotor by 1 mrad a tick so that each sample tells its own tick.
void turn(BoardFixture& f, int ticks) {
    for (int i = 0; i < ticks; ++i) {
        f.angle_rad += 1e-3;
        f.tick();
    }
}

TEST(Capture, fillsFromTheNextTickWithoutATrigger) {
    BoardFixture f;
    f.angle_rad = 0.0;
    f.driveIn(HB_MODE_CURRENT);
    configure(f, HB_TRIGGER_IMMEDIATE, 0);
    start(f);
    turn(f, 4095);
    EXPECT_EQ(f.board().signals.board.capture_state, HB_CAPTURE_RUNNING);
    turn(f, 1);
    EXPECT_EQ(f.board().signals.board.capture_state, HB_CAPTURE_FULL);
    turn(f, 100); // a full capture keeps its samples
    for (const std::uint32_t index : {0U, 1U, 2000U, 4095U}) {
        // one count of the position is 24 urad
        EXPECT_NEAR(static_cast<double>(sampleOverTheWire(f, 0, index)), 1e-3 * (index + 1), 3e-5);
    }
    EXPECT_EQ(sampleOverTheWire(f, 2, 17), 0.0F); // no signal chosen
}

TEST(Capture, showsTheTriggerBehindThePretrigger) {
    BoardFixture f;
    f.driveIn(HB_MODE_CURRENT);
    configure(f, HB_TRIGGER_LEVEL, 1000);
    f.writeLive(offsetof(hb_htm_live, capture.config.level), f.octetsOf(1.0F));
    start(f);
    f.tick(999);
    EXPECT_EQ(f.board().signals.board.capture_state, HB_CAPTURE_FILLING);
    f.setSetpoint(2.0F);
    f.tick(); // the crossing while the history still fills does not count
    EXPECT_EQ(f.board().signals.board.capture_state, HB_CAPTURE_WAITING);
    f.tick(5000);
    EXPECT_EQ(f.board().signals.board.capture_state, HB_CAPTURE_WAITING);
    f.setSetpoint(0.5F);
    f.tick(7);
    f.setSetpoint(1.5F);
    f.tick(HB_CAPTURE_SAMPLES - 1000);
    ASSERT_EQ(f.board().signals.board.capture_state, HB_CAPTURE_FULL);
    EXPECT_EQ(sampleOverTheWire(f, 1, 1000 - 8), 2.0F);
    EXPECT_EQ(sampleOverTheWire(f, 1, 999), 0.5F);
    EXPECT_EQ(sampleOverTheWire(f, 1, 1000), 1.5F);
    EXPECT_EQ(f.board().signals.board.capture_time_us, 1000U * (1 + 999 + 1 + 5000 + 7));
}

TEST(Capture, triggersOnAFallingLevel) {
    BoardFixture f;
    f.driveIn(HB_MODE_CURRENT);
    configure(f, HB_TRIGGER_LEVEL, 0);
    f.writeLive(offsetof(hb_htm_live, capture.config.slope), {HB_SLOPE_FALLING});
    f.writeLive(offsetof(hb_htm_live, capture.config.level), f.octetsOf(1.0F));
    start(f);
    f.setSetpoint(2.0F);
    f.tick(10);
    EXPECT_EQ(f.board().signals.board.capture_state, HB_CAPTURE_WAITING);
    f.setSetpoint(0.0F);
    f.tick();
    EXPECT_EQ(f.board().signals.board.capture_state, HB_CAPTURE_RUNNING);
}

TEST(Capture, triggersWithTheReference) {
    BoardFixture f;
    f.driveIn(HB_MODE_POSITION);
    configure(f, HB_TRIGGER_REFERENCE, 50);
    f.writeLive(offsetof(hb_htm_live, capture.config.signal), {ReferenceHandle});
    start(f);
    f.tick(73);
    f.writeLive(offsetof(hb_htm_live, reference.shape), {HB_SHAPE_STEP});
    f.writeLive(offsetof(hb_htm_live, reference.amplitude), f.octetsOf(0.1F));
    f.writeLive(offsetof(hb_htm_live, board.reference_start), {1});
    f.tick(5000);
    ASSERT_EQ(f.board().signals.board.capture_state, HB_CAPTURE_FULL);
    EXPECT_NEAR(static_cast<double>(sampleOverTheWire(f, 0, 49)), 0.3, 1e-6);
    EXPECT_NEAR(static_cast<double>(sampleOverTheWire(f, 0, 50)), 0.4, 1e-6);
    EXPECT_EQ(f.board().signals.board.capture_time_us % 10000, 0U); // the step comes with the position loop
}

TEST(Capture, spacesItsSamplesByThePrescaler) {
    BoardFixture f;
    f.angle_rad = 0.0;
    f.driveIn(HB_MODE_CURRENT);
    configure(f, HB_TRIGGER_IMMEDIATE, 0);
    f.writeLive(offsetof(hb_htm_live, capture.config.prescaler), {3, 0});
    start(f);
    turn(f, 3 * HB_CAPTURE_SAMPLES);
    ASSERT_EQ(f.board().signals.board.capture_state, HB_CAPTURE_FULL);
    const double spacing = static_cast<double>(sampleOverTheWire(f, 0, 4000)) -
                           static_cast<double>(sampleOverTheWire(f, 0, 3000));
    EXPECT_NEAR(spacing, 3.0, 5e-5);
}

TEST(Capture, recordsTheCallersOwnSignals) {
    double truth = -2.5;
    const hb_signal signal = truthSignal();
    hb_htm_config config{};
    config.extra = {&signal, 1, &truth};
    BoardFixture f(&config);
    f.driveIn(HB_MODE_CURRENT);
    const auto handle = static_cast<std::uint8_t>(f.board().board.xcp.description.signals[0].count);
    f.writeLive(offsetof(hb_htm_live, capture.config.signal), {handle, 255, 255, 255});
    start(f);
    f.tick(10);
    truth = 1.0 / 3.0;
    f.tick(HB_CAPTURE_SAMPLES - 10);
    ASSERT_EQ(f.board().signals.board.capture_state, HB_CAPTURE_FULL);
    EXPECT_EQ(sampleOverTheWire(f, 0, 9), -2.5F);
    EXPECT_EQ(sampleOverTheWire(f, 0, 10), 1.0F / 3.0F); // the nearest float
}

TEST(Capture, runsOncePerStartAndCanBeStopped) {
    BoardFixture f;
    f.driveIn(HB_MODE_CURRENT);
    configure(f, HB_TRIGGER_LEVEL, 0);
    start(f);
    f.tick(3);
    f.writeLive(offsetof(hb_htm_live, capture.start), {0});
    f.tick();
    EXPECT_EQ(f.board().signals.board.capture_state, HB_CAPTURE_IDLE);
}

} // namespace
} // namespace halbench::devices::firmware
