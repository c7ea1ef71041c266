#include "tests/conformance/actuator/toy_board.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

// The axes of hb_axes.h, tick by tick, with the positions that the test says.

namespace halbench::devices::firmware {
namespace {

class Axes : public ::testing::Test {
protected:
    Axes() : m_axes(std::make_unique<hb_axes>()) { restart(); }

    void restart() {
        hb_axes_init(m_axes.get(), &toy_actuator, nullptr);
        tick();
        command({0xFF, 0x00});
    }

    hb_axes& axes() { return *m_axes; }
    const hb_axis_signals& x() const { return m_axes->signals.axis[0]; }
    const hb_axis_signals& y() const { return m_axes->signals.axis[1]; }

    void tick(float x_m = 0.0F, float y_m = 0.0F) {
        const float positions_m[HB_AXES_MOST] = {x_m, y_m};
        hb_board_tick(&m_axes->board, positions_m);
    }
    void arm(std::uint8_t mode) {
        write(offsetof(hb_axes_live, board.mode), mode);
        write(offsetof(hb_axes_live, board.arm), 1);
        ASSERT_EQ(m_axes->live.board.arm, 1);
    }
    void startReference() { write(offsetof(hb_axes_live, board.reference_start), 1); }

private:
    void write(std::size_t offset, std::uint8_t value) {
        command({0xED, 1, 0, 0, static_cast<std::uint8_t>(offset), 0x80, 0, 0, value});
    }
    void command(const std::vector<std::uint8_t>& packet) {
        hb_board_receive(&m_axes->board, packet.data(), static_cast<std::uint16_t>(packet.size()));
        std::uint8_t buffer[HB_MAX_DTO];
        while (hb_board_transmit(&m_axes->board, buffer, sizeof buffer) != 0) {
        }
    }

    std::unique_ptr<hb_axes> m_axes;
};

TEST_F(Axes, eachFollowsItsOwnSetPointByItsOwnGains) {
    arm(HB_AXES_POSITION);
    tick(); // takes the mode
    axes().live.axis[0].setpoint = 0.001F;
    axes().live.axis[1].setpoint = -0.002F;
    axes().pages[axes().board.xcp.active_page].axis[1].kp = 300.0F;
    tick();
    EXPECT_FLOAT_EQ(x().command, 0.1F);  // 100 A/m times 1 mm, at rest
    EXPECT_FLOAT_EQ(y().command, -0.6F); // 300 A/m times -2 mm
    EXPECT_FLOAT_EQ(axes().signals.output[0], 0.1F);
    EXPECT_FLOAT_EQ(axes().signals.output[1], -0.6F);
}

TEST_F(Axes, setPointsCountFromWhereTheModeBegan) {
    tick(0.010F, 0.020F);
    tick(0.010F, 0.020F);
    arm(HB_AXES_POSITION);
    tick(0.010F, 0.020F);
    axes().live.axis[0].setpoint = 0.001F;
    tick(0.010F, 0.020F);
    EXPECT_FLOAT_EQ(x().reference, 0.011F);
    EXPECT_FLOAT_EQ(y().reference, 0.020F);
    EXPECT_NEAR(x().command, 0.1F, 1e-6F); // 0.011 - 0.010 in single precision: 1e-9 m, times 100 A/m
    EXPECT_EQ(y().command, 0.0F);
}

TEST_F(Axes, effortsStayWithinTheLimitOfTheirAxis) {
    arm(HB_AXES_EFFORT);
    tick();
    axes().live.axis[0].setpoint = 5.0F;
    axes().live.axis[1].setpoint = -1.5F;
    tick();
    EXPECT_EQ(axes().signals.output[0], 2.0F); // the limit of the table
    EXPECT_EQ(axes().signals.output[1], -1.5F);
}

TEST_F(Axes, anExcitationIsAddedToTheEffortAndLeavesTheReference) {
    arm(HB_AXES_POSITION);
    tick();
    for (hb_axis_live& live : axes().live.axis) {
        live.reference.shape = HB_SHAPE_STEP;
        live.reference.amplitude = 0.002F; // m on x, A on y
        live.reference.duration_s = 0.5F;  // the watchdog stops after 1 s
    }
    axes().live.axis[1].target = HB_AXES_TO_EFFORT;
    startReference();
    tick();
    EXPECT_FLOAT_EQ(x().reference, 0.002F);
    EXPECT_FLOAT_EQ(x().command, 0.2F); // 100 A/m times 2 mm
    EXPECT_EQ(y().reference, 0.0F);
    EXPECT_FLOAT_EQ(y().command, 0.002F); // the excitation alone: y is where it shall be
    EXPECT_EQ(axes().signals.board.reference_running, 1);
    for (int i = 0; i < 501; ++i) {
        tick();
    }
    EXPECT_EQ(axes().signals.board.reference_running, 0);
    EXPECT_FLOAT_EQ(x().reference, 0.002F); // a position is held
    EXPECT_EQ(y().command, 0.0F);           // an excitation ends
}

TEST_F(Axes, aSpeedOrPositionOutsideTheWindowOfOneAxisStopsAll) {
    for (const bool isFast : {true, false}) {
        restart();
        const float step_m = isFast ? 0.002F : 0.0005F; // 2 m/s, allowed is 1 m/s; or 0.5 m/s
        arm(HB_AXES_EFFORT);
        tick();
        axes().live.axis[0].setpoint = 1.0F;
        float y_m = 0.0F;
        int ticks = 0;
        while (axes().signals.board.fault == HB_FAULT_NONE && ticks < 1000) {
            y_m += step_m;
            tick(0.0F, y_m);
            ++ticks;
        }
        // One step is too fast; the window of 0.1 m is left by the 201st of 0.5 mm, or one earlier by
        // rounding.
        EXPECT_EQ(axes().signals.board.fault, isFast ? HB_FAULT_SPEED : HB_FAULT_POSITION);
        EXPECT_NEAR(ticks, isFast ? 1 : 201, isFast ? 0 : 1);
        EXPECT_EQ(axes().signals.output[0], 0.0F);
    }
}

TEST_F(Axes, aPositionThatIsNotFiniteIsAFault) {
    tick(std::numeric_limits<float>::quiet_NaN());
    EXPECT_EQ(axes().signals.board.fault, HB_FAULT_NOT_FINITE);
}

} // namespace
} // namespace halbench::devices::firmware
