#include "tests/conformance/actuator/toy_board.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

// What the board guarantees for every actuator, shown with hooks that do nothing and hooks that misbehave.

namespace halbench::devices::firmware {
namespace {

using Octets = std::vector<std::uint8_t>;
const Octets Accepted{0xFF};
const Octets Denied{0xFE, HB_ERR_ACCESS_DENIED};

constexpr float Demand_A = 1.5F;

/// The toy's tables with hooks that neither sense nor stop: `drive` demands a current for ever.
hb_actuator heedless() {
    hb_actuator actuator = toy_actuator;
    actuator.sense = [](void*, const void*, const void*) {};
    actuator.supervise = [](void*, const void*) {};
    actuator.control = actuator.supervise;
    actuator.drive = [](void* context, const void*) {
        static_cast<hb_axes*>(context)->signals.output[0] = Demand_A;
    };
    actuator.enter_mode = [](void*, std::uint8_t) {};
    return actuator;
}

/// As above, and it would brake for ever: `brake` says each time that the motion is not over.
hb_actuator brakingForEver(std::uint16_t brake_ms) {
    hb_actuator actuator = heedless();
    actuator.brake = [](void* context, const void*) -> std::uint8_t {
        static_cast<hb_axes*>(context)->signals.output[0] = -Demand_A;
        return 1;
    };
    actuator.brake_ms = brake_ms;
    actuator.braking_faults = 1U << HB_FAULT_SPEED;
    return actuator;
}

class Bench {
public:
    explicit Bench(const hb_actuator& actuator) : m_actuator(actuator), m_toy(std::make_unique<hb_axes>()) {
        hb_axes_init(m_toy.get(), &m_actuator, nullptr);
    }

    hb_axes& toy() { return *m_toy; }
    hb_board& board() { return m_toy->board; }
    float current_A() const { return m_toy->signals.output[0]; }

    void tick(int count = 1) {
        const float positions_m[HB_AXES_MOST] = {};
        for (int i = 0; i < count; ++i) {
            hb_board_tick(&board(), positions_m);
        }
    }

    Octets command(const Octets& packet) {
        hb_board_receive(&board(), packet.data(), static_cast<std::uint16_t>(packet.size()));
        std::uint8_t buffer[HB_MAX_DTO];
        Octets answer;
        while (const std::uint16_t length = hb_board_transmit(&board(), buffer, sizeof buffer)) {
            if (buffer[0] >= 0xFE && answer.empty()) {
                answer.assign(buffer, buffer + length);
            }
        }
        return answer;
    }

    Octets write(std::size_t offset, std::uint8_t value) {
        return command({0xED, 1, 0, 0, static_cast<std::uint8_t>(offset), 0x80, 0, 0, value});
    }
    Octets arm() { return write(offsetof(hb_axes_live, board.arm), 1); }
    Octets stop() { return command({0xF1, 0x45}); }
    Octets reset() { return command({0xF1, 0x52}); }

    /// Connected, armed and with current in its coil.
    void start() {
        tick();
        command({0xFF, 0x00});
        write(offsetof(hb_axes_live, board.mode), HB_AXES_EFFORT);
        ASSERT_EQ(arm(), Accepted);
        tick();
        ASSERT_EQ(current_A(), Demand_A);
    }

private:
    hb_actuator m_actuator;
    std::unique_ptr<hb_axes> m_toy;
};

void expectStopped(Bench& bench, std::uint8_t status) {
    bench.tick();
    EXPECT_EQ(bench.current_A(), 0.0F);
    EXPECT_EQ(bench.toy().signals.board.status, status);
    EXPECT_EQ(bench.toy().live.board.arm, 0);
    bench.command({0xFF, 0x00});
    EXPECT_EQ(bench.arm(), Denied);
    bench.tick(100);
    EXPECT_EQ(bench.current_A(), 0.0F);
    EXPECT_EQ(bench.reset(), (Octets{0xFF, HB_LATCH_NONE}));
    EXPECT_EQ(bench.arm(), Accepted);
}

TEST(BoardSafety, armsOnlyAfterTheFirstTick) {
    Bench bench(heedless());
    bench.command({0xFF, 0x00});
    EXPECT_EQ(bench.arm(), (Octets{0xFE, HB_ERR_BUSY}));
    bench.tick();
    EXPECT_EQ(bench.arm(), Accepted);
}

TEST(BoardSafety, stopsByCommandWhateverTheHooksDo) {
    Bench bench(heedless());
    bench.start();
    EXPECT_EQ(bench.stop(), (Octets{0xFF, HB_LATCH_COMMAND}));
    EXPECT_EQ(bench.current_A(), 0.0F); // before the next tick, too
    expectStopped(bench, HB_STATUS_STOPPED);
}

TEST(BoardSafety, stopsWhenTheMasterFallsSilent) {
    Bench bench(heedless());
    bench.start();
    EXPECT_EQ(bench.toy().live.board.watchdog_ms, 1000); // the board's own when none was asked for
    bench.tick(997);
    EXPECT_EQ(bench.current_A(), Demand_A);
    bench.tick(5);
    expectStopped(bench, HB_STATUS_WATCHDOG);
}

TEST(BoardSafety, keepsAFaultUntilTheReset) {
    Bench bench(heedless());
    bench.start();
    hb_board_raise_fault(&bench.board(), HB_FAULT_SPEED);
    hb_board_raise_fault(&bench.board(), HB_FAULT_CURRENT);
    bench.tick();
    EXPECT_EQ(bench.toy().signals.board.fault, HB_FAULT_SPEED); // the first
    expectStopped(bench, HB_STATUS_FAULT);
}

TEST(BoardSafety, driveThatIsNotFiniteBecomesAFault) {
    hb_actuator actuator = heedless();
    actuator.control = [](void* context, const void*) {
        static_cast<hb_axes*>(context)->signals.output[1] = std::numeric_limits<float>::quiet_NaN();
    };
    Bench bench(actuator);
    bench.tick();
    bench.command({0xFF, 0x00});
    bench.write(offsetof(hb_axes_live, board.mode), HB_AXES_EFFORT);
    ASSERT_EQ(bench.arm(), Accepted);
    bench.tick();
    EXPECT_EQ(bench.toy().signals.output[0], 0.0F);
    EXPECT_EQ(bench.toy().signals.output[1], 0.0F);
    EXPECT_EQ(bench.toy().signals.board.fault, HB_FAULT_NOT_FINITE);
    EXPECT_EQ(bench.toy().signals.board.status, HB_STATUS_FAULT);
}

TEST(BoardSafety, disarmingAndAnotherMasterEndTheDriving) {
    Bench bench(heedless());
    bench.start();
    EXPECT_EQ(bench.write(offsetof(hb_axes_live, board.arm), 0), Accepted);
    bench.tick();
    EXPECT_EQ(bench.current_A(), 0.0F);
    bench.start();
    bench.command({0xFF, 0x00});
    bench.tick();
    EXPECT_EQ(bench.current_A(), 0.0F);
    EXPECT_EQ(bench.toy().signals.board.status, HB_STATUS_IDLE);
}

TEST(BoardSafety, aLostMasterBringsTheCalibrationOfBeforeTheTrialBack) {
    Bench bench(heedless());
    bench.start();
    bench.write(offsetof(hb_axes_live, board.trial), 1);
    bench.toy().pages[bench.board().xcp.next_page].axis[0].kp = 1.0F;
    bench.tick(1010);
    EXPECT_EQ(bench.toy().pages[bench.board().xcp.active_page].axis[0].kp, 100.0F);
    EXPECT_EQ(bench.toy().live.board.trial, 0);
}

TEST(BoardSafety, brakingEndsAfterItsTimeAtTheLatest) {
    for (const bool byWatchdog : {false, true}) {
        Bench bench(brakingForEver(300));
        bench.start();
        if (byWatchdog) {
            bench.tick(998);
            ASSERT_EQ(bench.toy().signals.board.status, HB_STATUS_ARMED);
            while (bench.toy().signals.board.status == HB_STATUS_ARMED) {
                bench.tick(); // the last of these is the first that brakes
            }
        } else {
            bench.stop();
            bench.tick();
        }
        EXPECT_EQ(bench.current_A(), -Demand_A);
        bench.tick(299);
        EXPECT_EQ(bench.current_A(), -Demand_A) << "300 ms are 300 ticks";
        EXPECT_NE(hb_safety_latch(&bench.board().safety), HB_LATCH_NONE);
        bench.tick();
        EXPECT_EQ(bench.current_A(), 0.0F);
        EXPECT_EQ(hb_board_is_driving(&bench.board()), 0);
    }
}

TEST(BoardSafety, aSecondStopDoesNotProlongTheBraking) {
    Bench bench(brakingForEver(300));
    bench.start();
    bench.stop();
    bench.tick(200);
    bench.stop();
    bench.tick(101);
    EXPECT_EQ(bench.current_A(), 0.0F);
}

TEST(BoardSafety, brakesAfterFaultsThatLeaveTheSensorsGoodAndAfterNoOther) {
    Bench bench(brakingForEver(300));
    bench.start();
    hb_board_raise_fault(&bench.board(), HB_FAULT_SPEED);
    bench.tick();
    EXPECT_EQ(bench.current_A(), -Demand_A);
    hb_board_raise_fault(&bench.board(), HB_FAULT_SENSOR_RANGE); // while it brakes
    EXPECT_EQ(bench.current_A(), 0.0F);
    bench.tick();
    EXPECT_EQ(bench.current_A(), 0.0F);

    Bench blind(brakingForEver(300));
    blind.start();
    hb_board_raise_fault(&blind.board(), HB_FAULT_SENSOR_RANGE);
    blind.tick();
    EXPECT_EQ(blind.current_A(), 0.0F);
}

TEST(BoardSafety, modeIdleBrakesWhileTheBoardStaysArmed) {
    Bench bench(brakingForEver(300));
    bench.start();
    EXPECT_EQ(bench.write(offsetof(hb_axes_live, board.mode), HB_MODE_IDLE), Accepted);
    bench.tick(300);
    EXPECT_EQ(bench.current_A(), -Demand_A);
    bench.tick();
    EXPECT_EQ(bench.current_A(), 0.0F);
    EXPECT_EQ(bench.toy().signals.board.status, HB_STATUS_ARMED);
    EXPECT_EQ(bench.write(offsetof(hb_axes_live, board.mode), HB_AXES_EFFORT), Accepted);
    bench.tick();
    EXPECT_EQ(bench.current_A(), Demand_A);
}

TEST(BoardSafety, anActuatorAtRestDoesNotBrake) {
    Bench bench(brakingForEver(300));
    bench.tick();
    bench.command({0xFF, 0x00});
    bench.stop(); // was never armed
    bench.tick();
    EXPECT_EQ(bench.current_A(), 0.0F);
}

} // namespace
} // namespace halbench::devices::firmware
