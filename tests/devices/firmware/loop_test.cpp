#include "tests/devices/firmware/board_fixture.h"

#include <gtest/gtest.h>

namespace halbench::devices::firmware {
namespace {

std::size_t offsetOf(float hb_htm_calibration::*member) {
    const hb_htm_calibration page{};
    return static_cast<std::size_t>(reinterpret_cast<const char*>(&(page.*member)) -
                                    reinterpret_cast<const char*>(&page));
}

void set(BoardFixture& f, float hb_htm_calibration::*member, double value) {
    ASSERT_EQ(f.writePaged(offsetOf(member), static_cast<float>(value)), Accepted);
}

TEST(Loop, commutatesOnlyEveryTenthMillisecondWhenAsked) {
    // The what-if of resources/help/htm-theory.md 3.8: the currents stand still while the rotor turns on.
    BoardFixture f;
    f.driveIn(HB_MODE_CURRENT);
    set(f, &hb_htm_calibration::commutation_divider, 10);
    f.setSetpoint(2.0F);
    f.tick(9); // ticks 1..9
    EXPECT_EQ(f.outputs.phase_current_A[0], 0.0F);
    double angle_of_commutation = 0.0;
    for (int tick = 10; tick < 40; ++tick) {
        f.angle_rad += 0.02;
        if (tick % 10 == 0) {
            angle_of_commutation = f.angle_rad;
        }
        f.tick();
        // no stray field in this rotor: the board's compensation shifts the angle by at most 2.5e-3*2/0.157
        // rad
        ASSERT_NEAR(static_cast<double>(f.outputs.phase_current_A[0]), -2.0 * std::sin(angle_of_commutation),
                    0.07);
        ASSERT_NEAR(std::hypot(f.outputs.phase_current_A[0], f.outputs.phase_current_A[1]), 2.0, 1e-6);
    }
}

TEST(Loop, advancesTheCommutationAngleWithTheSpeed) {
    BoardFixture f;
    f.driveIn(HB_MODE_CURRENT);
    set(f, &hb_htm_calibration::stray_enabled, 0);
    set(f, &hb_htm_calibration::commutation_advance, 0.002);
    f.setSetpoint(2.0F);
    for (int i = 0; i < 200; ++i) {
        f.angle_rad += 0.02; // 20 rad/s
        f.tick();
    }
    const double commutated = std::atan2(-f.outputs.phase_current_A[0], f.outputs.phase_current_A[1]);
    EXPECT_NEAR(std::remainder(commutated - f.angle_rad, 2 * Pi), 20 * 0.002, 1e-4);
}

/// Ticks of a rotor at 0.8 rad whose sensors see the currents written the tick before, 2.5 mT/A.
void tickWithStray(BoardFixture& f, int count) {
    for (int i = 0; i < count; ++i) {
        hb_htm_inputs in{};
        for (int phase = 0; phase < 2; ++phase) {
            const double field = FieldAmplitude_T * (phase == 0 ? std::cos(0.8) : std::sin(0.8)) +
                                 2.5e-3 * static_cast<double>(f.outputs.phase_current_A[phase]);
            in.hall_code[phase] = static_cast<float>(hallCode(field));
            in.temperature_code[phase] = static_cast<float>(temperatureCode(25.0));
        }
        hb_htm_fast_tick(&f.board(), &in, &f.outputs);
    }
}

TEST(Loop, compensatesTheStrayFieldOfItsOwnCurrents) {
    // Property 7 of resources/help/htm-theory.md 10: without compensation atan(k_s I/B0), with it zero.
    for (const bool compensated : {true, false}) {
        BoardFixture f;
        f.angle_rad = 0.8;
        f.driveIn(HB_MODE_CURRENT);
        set(f, &hb_htm_calibration::stray_enabled, compensated ? 1 : 0);
        f.setSetpoint(3.0F);
        tickWithStray(f, 50);
        // The currents stand perpendicular to the *measured* angle; solving the loop for that gives
        // sin(error) = k_s I/B0.
        const double expected = compensated ? 0.0 : std::asin(2.5e-3 * 3.0 / FieldAmplitude_T);
        EXPECT_NEAR(static_cast<double>(f.board().sensing.angle_rad) - 0.8, expected, 1e-5);
    }
}

TEST(Loop, theAngleDoesNotJumpWhereTheCurrentEnds) {
    // Until the tick after a stop the sensors still see the field of the current before it.
    const Octets disarmed{0};
    for (const bool byStop : {true, false}) {
        BoardFixture f;
        f.angle_rad = 0.8;
        f.driveIn(HB_MODE_CURRENT);
        f.setSetpoint(3.0F);
        tickWithStray(f, 50);
        byStop ? f.stop() : f.writeLive(offsetof(hb_htm_live, board.arm), disarmed);
        for (int i = 0; i < 3; ++i) {
            tickWithStray(f, 1);
            EXPECT_TRUE(f.isOutputZero());
            // Rounding of single precision; the jump was asin(k_s I/B0) = 0.048 rad.
            EXPECT_NEAR(static_cast<double>(f.board().sensing.angle_rad), 0.8, 1e-5) << byStop << i;
        }
    }
}

TEST(Loop, showsTheRawFieldsAndTheTemperatures) {
    BoardFixture f;
    f.angle_rad = 2.0;
    f.temperature_degC = 45.0;
    f.connect();
    set(f, &hb_htm_calibration::hall_offset_a, 0.01); // a correction must not change what is shown
    f.tick();
    // The fixture's codes hold for 25 degC; at 45 degC the board divides by 1 + 0.0012 * 20.
    EXPECT_NEAR(static_cast<double>(f.board().signals.hall_T[0]), FieldAmplitude_T * std::cos(2.0) / 1.024,
                1e-6);
    EXPECT_NEAR(static_cast<double>(f.board().signals.hall_T[1]), FieldAmplitude_T * std::sin(2.0) / 1.024,
                1e-6);
    EXPECT_NEAR(static_cast<double>(f.board().signals.temperature_degC[1]), 45.0, 1e-3);
}

TEST(Loop, takesTheDecodingFromThePage) {
    BoardFixture f;
    f.angle_rad = 0.25;
    f.connect();
    set(f, &hb_htm_calibration::decode_method, HB_DECODE_LINEAR);
    f.tick();
    // q B_B with q = (pi/4)/(B0 sin 45 deg)
    EXPECT_NEAR(static_cast<double>(f.board().sensing.angle_rad), Pi / 4 * std::sin(0.25) / std::sqrt(0.5),
                1e-6);
}

TEST(Loop, runsThePositionLawEveryTenMilliseconds) {
    BoardFixture f;
    f.driveIn(HB_MODE_POSITION);
    f.setSetpoint(0.1F);
    int changes = 0;
    float last = f.outputs.current_command_A;
    set(f, &hb_htm_calibration::ki, 100.0); // the integral changes the command at every sample of the loop
    for (int i = 0; i < 100; ++i) {
        f.tick();
        changes += f.outputs.current_command_A != last;
        last = f.outputs.current_command_A;
    }
    EXPECT_EQ(changes, 10);
}

TEST(Loop, feedsEveryGainOfThePageToTheLaw) {
    // Shape of the recommended preset (resources/help/htm-theory.md 8.4), softer so that nothing saturates:
    // first sample of a ramp of 2 rad/s with the rotor held.
    BoardFixture f;
    f.driveIn(HB_MODE_POSITION);
    set(f, &hb_htm_calibration::kp, 20);
    set(f, &hb_htm_calibration::ki, 60);
    set(f, &hb_htm_calibration::kd, 0.2);
    set(f, &hb_htm_calibration::ff_viscous, 0.086);
    set(f, &hb_htm_calibration::ff_coulomb, 1.29);
    set(f, &hb_htm_calibration::stiction_current, 1.29);
    f.writeLive(offsetof(hb_htm_live, reference.shape), {HB_SHAPE_RAMP});
    f.writeLive(offsetof(hb_htm_live, reference.rate), f.octetsOf(2.0F));
    f.writeLive(offsetof(hb_htm_live, board.reference_start), {1});
    while (f.board().signals.board.reference_running == 0) {
        f.tick();
    }
    EXPECT_NEAR(static_cast<double>(f.outputs.current_command_A), 0.2 * 2 + 0.086 * 2 + 1.29, 1e-5);
    f.tick(10);
    // 10 ms later: error 0.02 rad, and the compensated stray field of this rotor without any turns the angle
    // back
    const double measured =
        static_cast<double>(hb_htm_signals(f.board().signals).position) * 2 * Pi / 262144 - 0.3;
    EXPECT_NEAR(static_cast<double>(f.outputs.current_command_A),
                20 * (0.02 - measured) + 0.2 * (2 - measured / 0.01) + 0.086 * 2 + 1.29, 5e-3);
}

TEST(Loop, appliesTheDelayOfThePage) {
    BoardFixture f;
    f.driveIn(HB_MODE_POSITION);
    set(f, &hb_htm_calibration::delay_samples, 2);
    f.setSetpoint(0.1F);
    while (f.board().board.loop_phase != 0) {
        f.tick();
    }
    f.tick(20);
    EXPECT_EQ(f.outputs.current_command_A, 0.0F);
    f.tick();
    EXPECT_NEAR(static_cast<double>(f.outputs.current_command_A), 1.0, 1e-4);
}

} // namespace
} // namespace halbench::devices::firmware
