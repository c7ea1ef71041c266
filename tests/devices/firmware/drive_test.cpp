#include "tests/devices/firmware/board_fixture.h"

#include <gtest/gtest.h>

#include <limits>

namespace halbench::devices::firmware {
namespace {

constexpr float NaN = std::numeric_limits<float>::quiet_NaN();

/// Current at a rotor that is held still.
BoardFixture& drivingWith(BoardFixture& f, float current_A) {
    f.driveIn(HB_MODE_CURRENT);
    f.setSetpoint(current_A);
    f.tick();
    EXPECT_FALSE(f.isOutputZero());
    return f;
}

TEST(Drive, turnsTheCommandIntoTorqueCurrents) {
    // I_A = -I sin psi, I_B = +I cos psi (resources/help/htm-theory.md 3.1); float keeps 1e-6 of 4 A.
    BoardFixture f;
    f.angle_rad = 2.1;
    drivingWith(f, 3.0F);
    EXPECT_NEAR(f.outputs.phase_current_A[0], -3.0 * std::sin(2.1), 2e-6);
    EXPECT_NEAR(f.outputs.phase_current_A[1], 3.0 * std::cos(2.1), 2e-6);
    EXPECT_EQ(f.outputs.current_command_A, 3.0F);
    // code = 4096/5 (2.5 V + I/2), rounded
    EXPECT_EQ(f.outputs.dac_code[0], std::lround(2048 + 409.6 * -3.0 * std::sin(2.1)));
    EXPECT_EQ(f.outputs.dac_code[1], std::lround(2048 + 409.6 * 3.0 * std::cos(2.1)));
}

TEST(Drive, putsTheDAxisCurrentAlongTheField) {
    BoardFixture f;
    f.angle_rad = -0.7;
    f.driveIn(HB_MODE_D_AXIS);
    f.setSetpoint(2.0F);
    f.tick();
    EXPECT_NEAR(f.outputs.phase_current_A[0], 2.0 * std::cos(-0.7), 2e-6);
    EXPECT_NEAR(f.outputs.phase_current_A[1], 2.0 * std::sin(-0.7), 2e-6);
}

TEST(Drive, isSilentInModeIdleAndBeforeArming) {
    BoardFixture f;
    f.tick();
    f.connect();
    f.setMode(HB_MODE_CURRENT);
    f.setSetpoint(2.0F);
    f.tick();
    EXPECT_TRUE(f.isOutputZero());
    f.setMode(HB_MODE_IDLE);
    EXPECT_EQ(f.arm(), Accepted);
    f.setSetpoint(2.0F);
    f.tick();
    EXPECT_TRUE(f.isOutputZero());
}

TEST(Drive, startsWithSetPointZero) {
    BoardFixture f;
    f.tick();
    f.connect();
    f.setMode(HB_MODE_CURRENT);
    f.setSetpoint(3.0F);
    EXPECT_EQ(f.arm(), Accepted);
    f.tick();
    EXPECT_EQ(f.outputs.current_command_A, 0.0F);
    f.setSetpoint(3.0F);
    f.setMode(HB_MODE_D_AXIS); // another mode starts at zero, too
    f.tick();
    EXPECT_EQ(f.outputs.current_command_A, 0.0F);
}

TEST(Drive, startsThePositionReferenceWhereTheRotorIs) {
    BoardFixture f;
    f.angle_rad = 1.7;
    f.driveIn(HB_MODE_POSITION);
    f.tick(20);
    EXPECT_NEAR(f.board().signals.reference, 1.7, 1e-6);
    EXPECT_NEAR(f.outputs.current_command_A, 0.0, 1e-4);
    f.setSetpoint(0.1F);
    f.tick(10);
    EXPECT_NEAR(f.board().signals.reference, 1.8, 1e-6);
    EXPECT_NEAR(f.outputs.current_command_A, 10 * 0.1, 1e-4); // Kp e
}

TEST(Drive, setsTheWatchdogWhenArmedWithoutOne) {
    BoardFixture f;
    f.tick();
    f.connect();
    EXPECT_EQ(f.arm(), Accepted);
    EXPECT_EQ(f.board().live.board.watchdog_ms, 1000);
    BoardFixture other;
    other.tick();
    other.connect();
    other.writeLive(offsetof(hb_htm_live, board.watchdog_ms), {44, 1});
    other.arm();
    EXPECT_EQ(other.board().live.board.watchdog_ms, 300);
}

TEST(Drive, refusesToArmBeforeItKnowsTheAngle) {
    BoardFixture f;
    f.connect();
    EXPECT_EQ(f.arm(), refused(0x10));
    f.tick();
    EXPECT_EQ(f.arm(), Accepted);
}

TEST(Drive, refusesASetPointAboveTheCurrentLimit) {
    BoardFixture f;
    f.driveIn(HB_MODE_CURRENT);
    EXPECT_EQ(f.setSetpoint(4.01F), refused(0x22));
    EXPECT_EQ(f.setSetpoint(-4.0F), Accepted);
    f.tick();
    EXPECT_EQ(f.outputs.current_command_A, -4.0F);
    EXPECT_EQ(f.board().signals.board.status, HB_STATUS_ARMED);
}

TEST(Drive, goesToZeroWhenDisarmed) {
    BoardFixture f;
    drivingWith(f, 2.0F);
    EXPECT_EQ(f.writeLive(offsetof(hb_htm_live, board.arm), {0}), Accepted);
    f.tick();
    EXPECT_TRUE(f.isOutputZero());
    EXPECT_EQ(f.board().live.setpoint, 0.0F);
    EXPECT_EQ(f.board().signals.board.status, HB_STATUS_IDLE);
}

TEST(Stop, worksInEveryModeAndStaysLatched) {
    constexpr std::uint8_t Modes[] = {HB_MODE_IDLE, HB_MODE_CURRENT, HB_MODE_POSITION, HB_MODE_D_AXIS};
    for (const std::uint8_t mode : Modes) {
        BoardFixture f;
        f.driveIn(mode);
        f.writePaged(offsetof(hb_htm_calibration, stray_enabled), 0.0F); // this rotor's coils have none
        f.setSetpoint(1.0F);
        f.tick(10);
        EXPECT_EQ(f.stop(), (Octets{0xFF, HB_LATCH_COMMAND}));
        f.tick();
        EXPECT_TRUE(f.isOutputZero());
        EXPECT_EQ(f.board().signals.board.status, HB_STATUS_STOPPED);
        EXPECT_EQ(f.board().live.setpoint, 0.0F);
        EXPECT_EQ(f.arm(), refused(0x24));
        EXPECT_EQ(f.reset(), (Octets{0xFF, HB_LATCH_NONE}));
        EXPECT_EQ(f.arm(), Accepted);
        f.tick(20);
        EXPECT_NEAR(f.outputs.current_command_A, 0.0, 1e-5);
    }
}

TEST(Stop, worksWithoutASessionWhileTheGeneratorRuns) {
    BoardFixture f;
    f.driveIn(HB_MODE_CURRENT);
    f.writeLive(offsetof(hb_htm_live, reference.shape), {HB_SHAPE_STEP});
    f.writeLive(offsetof(hb_htm_live, reference.amplitude), f.octetsOf(2.0F));
    f.writeLive(offsetof(hb_htm_live, board.reference_start), {1});
    f.command({0xFE}); // DISCONNECT leaves the board to its watchdog
    f.tick();
    EXPECT_FALSE(f.isOutputZero());
    f.send({0xF1, 0x45});
    f.tick();
    EXPECT_TRUE(f.isOutputZero());
    EXPECT_EQ(f.board().signals.board.reference_running, 0);
}

TEST(Stop, canBeWrittenAsAParameterButNotTakenBack) {
    BoardFixture f;
    drivingWith(f, 2.0F);
    EXPECT_EQ(f.writeLive(offsetof(hb_htm_live, board.stop), {1}), Accepted);
    f.tick();
    EXPECT_TRUE(f.isOutputZero());
    EXPECT_EQ(f.writeLive(offsetof(hb_htm_live, board.stop), {0}), Accepted);
    f.tick();
    EXPECT_EQ(f.board().signals.board.status, HB_STATUS_STOPPED);
    EXPECT_EQ(f.board().live.board.stop, 1);
}

TEST(Watchdog, stopsAfterTheSilenceItWasSetTo) {
    BoardFixture f;
    drivingWith(f, 2.0F);
    f.writeLive(offsetof(hb_htm_live, board.watchdog_ms), {44, 1}); // 300 ms
    f.tick(299);
    EXPECT_FALSE(f.isOutputZero());
    f.tick();
    EXPECT_TRUE(f.isOutputZero());
    EXPECT_EQ(f.board().signals.board.status, HB_STATUS_WATCHDOG);
    EXPECT_EQ(f.received(), (std::vector<Octets>{{0xFD, 0x07, 0x02}}));
    EXPECT_TRUE(f.command({0xFD}).empty()); // the session is over
    f.connect();
    EXPECT_EQ(f.read(8 * 10, 1), (Octets{0xFF, HB_STATUS_WATCHDOG}));
    EXPECT_EQ(f.arm(), refused(0x24));
}

TEST(Watchdog, isRestartedByEveryWellFormedCommandOnly) {
    BoardFixture f;
    drivingWith(f, 2.0F);
    f.writeLive(offsetof(hb_htm_live, board.watchdog_ms), {100, 0});
    for (int i = 0; i < 20; ++i) {
        f.tick(99);
        f.command({0xFD});
    }
    EXPECT_FALSE(f.isOutputZero());
    for (int i = 0; i < 99; ++i) {
        f.command({0xCC}); // unknown
        f.tick();
    }
    f.tick();
    EXPECT_TRUE(f.isOutputZero());
}

TEST(Watchdog, actsAlsoWhenTheMasterLeftAnArmedBoard) {
    BoardFixture f;
    drivingWith(f, 2.0F);
    f.writeLive(offsetof(hb_htm_live, board.watchdog_ms), {100, 0});
    f.command({0xFE});
    f.tick(101);
    EXPECT_TRUE(f.isOutputZero());
    EXPECT_EQ(f.board().signals.board.status, HB_STATUS_WATCHDOG);
}

TEST(Watchdog, leavesForeignToolsAloneByDefault) {
    BoardFixture f;
    f.connect();
    f.tick(70000);
    EXPECT_EQ(f.board().signals.board.status, HB_STATUS_IDLE);
    EXPECT_EQ(f.command({0xFD}).size(), 6U);
}

void expectLatched(BoardFixture& f, std::uint8_t fault, const std::string& words) {
    EXPECT_TRUE(f.isOutputZero());
    EXPECT_EQ(f.board().signals.board.status, HB_STATUS_FAULT);
    EXPECT_EQ(f.board().signals.board.fault, fault);
    const std::vector<Octets> packets = f.received();
    ASSERT_EQ(packets.size(), 2U);
    EXPECT_EQ(packets[0], (Octets{0xFD, 0xFE, fault}));
    EXPECT_EQ(std::string(packets[1].begin() + 2, packets[1].end() - 1), words);
    EXPECT_EQ(f.arm(), refused(0x24));
}

TEST(Fault, isRaisedByAHotCoil) {
    BoardFixture f;
    drivingWith(f, 2.0F);
    f.temperature_degC = 79.9;
    f.tick();
    EXPECT_FALSE(f.isOutputZero());
    f.temperature_degC = 80.1;
    f.tick();
    expectLatched(f, HB_FAULT_TEMPERATURE, "coil temperature above its limit");
    f.reset();
    f.tick();
    EXPECT_EQ(f.board().signals.board.fault, HB_FAULT_TEMPERATURE); // still hot
    f.temperature_degC = 40.0;
    f.reset();
    f.tick();
    EXPECT_EQ(f.arm(), Accepted);
}

TEST(Fault, isRaisedByAReferenceAboveTheCurrentLimit) {
    BoardFixture f;
    f.driveIn(HB_MODE_CURRENT);
    f.writeLive(offsetof(hb_htm_live, reference.shape), {HB_SHAPE_RAMP});
    f.writeLive(offsetof(hb_htm_live, reference.rate), f.octetsOf(100.0F)); // 4 A after 40 ms
    f.writeLive(offsetof(hb_htm_live, board.reference_start), {1});
    f.tick(41);
    EXPECT_FALSE(f.isOutputZero());
    f.tick();
    expectLatched(f, HB_FAULT_CURRENT, "current above its limit");
}

TEST(Fault, isRaisedBySpeedAboveItsWindow) {
    BoardFixture f;
    drivingWith(f, 2.0F);
    const auto spin = [&f](double speed_rad_s) {
        for (int i = 0; i < 100; ++i) {
            f.angle_rad += speed_rad_s * 1e-3;
            f.tick();
        }
    };
    spin(39.0);
    EXPECT_FALSE(f.isOutputZero());
    spin(41.0);
    expectLatched(f, HB_FAULT_SPEED, "speed above its window");
}

TEST(Fault, isRaisedByLeavingThePositionWindow) {
    BoardFixture f;
    f.angle_rad = 3.0; // the window crosses the turn of the decoded angle
    drivingWith(f, 2.0F);
    f.writePaged(offsetof(hb_htm_calibration, stray_enabled), 0.0F); // this rotor's coils have no stray field
    f.writePaged(offsetof(hb_htm_calibration, window_position), 0.5F);
    f.writePaged(offsetof(hb_htm_calibration, window_position_enabled), 1.0F);
    f.angle_rad = 3.49;
    f.writePaged(offsetof(hb_htm_calibration, window_speed_enabled), 0.0F);
    f.tick(50);
    EXPECT_FALSE(f.isOutputZero());
    f.angle_rad = 3.51;
    f.tick();
    expectLatched(f, HB_FAULT_POSITION, "position left its window");
}

TEST(Fault, isRaisedByAnAngleThatJumpsMoreThanAQuarterTurn) {
    BoardFixture f;
    drivingWith(f, 2.0F);
    f.writePaged(offsetof(hb_htm_calibration, window_speed_enabled), 0.0F);
    f.angle_rad += 89.0 * Pi / 180.0;
    f.tick();
    EXPECT_FALSE(f.isOutputZero());
    f.angle_rad += 91.0 * Pi / 180.0;
    f.tick();
    expectLatched(f, HB_FAULT_ANGLE_JUMPED, "angle jumped (ambiguous decode)");
}

TEST(Fault, isRaisedByABrokenSensorWire) {
    for (const float code : {0.0F, 1023.0F}) {
        BoardFixture f;
        drivingWith(f, 2.0F);
        hb_htm_inputs in = f.inputs();
        in.hall_code[1] = code;
        hb_htm_fast_tick(&f.board(), &in, &f.outputs);
        expectLatched(f, HB_FAULT_SENSOR_RANGE, "sensor out of range");
    }
}

TEST(Fault, isRaisedByAFieldThatIsNotTheRotors) {
    BoardFixture f;
    drivingWith(f, 2.0F);
    hb_htm_inputs in = f.inputs();
    in.hall_code[0] = in.hall_code[1] = 511.5F; // no field at all
    hb_htm_fast_tick(&f.board(), &in, &f.outputs);
    EXPECT_EQ(f.board().signals.board.fault, HB_FAULT_SENSOR_RANGE);
}

TEST(Fault, isRaisedByEveryInputThatIsNotFinite) {
    for (int which = 0; which < 4; ++which) {
        for (const float bad : {NaN, std::numeric_limits<float>::infinity()}) {
            BoardFixture f;
            drivingWith(f, 2.0F);
            const std::int32_t before = f.board().signals.position;
            hb_htm_inputs in = f.inputs();
            (which < 2 ? in.hall_code[which] : in.temperature_code[which - 2]) = bad;
            hb_htm_fast_tick(&f.board(), &in, &f.outputs);
            expectLatched(f, HB_FAULT_NOT_FINITE, "value not finite");
            EXPECT_EQ(f.board().signals.position, before);
            EXPECT_TRUE(std::isfinite(f.board().signals.speed_rad_s));
            f.tick();
            EXPECT_EQ(f.board().signals.board.status, HB_STATUS_FAULT);
        }
    }
}

TEST(Fault, keepsTheFirstCause) {
    BoardFixture f;
    drivingWith(f, 2.0F);
    f.temperature_degC = 90.0;
    f.tick();
    hb_htm_inputs in = f.inputs();
    in.hall_code[0] = NaN;
    hb_htm_fast_tick(&f.board(), &in, &f.outputs);
    EXPECT_EQ(f.board().signals.board.fault, HB_FAULT_TEMPERATURE);
}

TEST(Board, runsManyTimesInOneProcess) {
    BoardFixture one;
    BoardFixture two;
    one.connect();
    one.writePaged(offsetof(hb_htm_calibration, kp), 99.0F);
    EXPECT_EQ(two.board().pages[0].kp, 10.0F);
    EXPECT_TRUE(two.command({0xFD}).empty());
}

} // namespace
} // namespace halbench::devices::firmware
