#include "control/base/units.h"
#include "devices/simulated/registry/simulated_device.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

// Plant, firmware and link together; figures of resources/help/htm-theory.md.

namespace halbench::devices {
namespace {

class Motor {
public:
    explicit Motor(const std::string& query) {
        auto opened = openSimulatedDevice(*parseDeviceUri("sim:htm?" + query), {});
        EXPECT_TRUE(opened) << opened.error().message;
        m_device = std::move(*opened);
    }

    void set(const std::string& name, double value) {
        const ParameterValue change[] = {{name, value}};
        const auto written = m_device->writeParameters(change);
        EXPECT_TRUE(written) << written.error().message;
    }

    void arm(BoardMode mode) {
        set("hb.mode", static_cast<double>(mode));
        const auto armed = m_device->arm();
        EXPECT_TRUE(armed) << armed.error().message;
    }

    void wait(double duration_s) {
        const auto waited = m_device->clock().waitFor(duration_s);
        EXPECT_TRUE(waited) << waited.error().message;
    }

    double signal(const std::string& name) {
        const std::string names[] = {name};
        return m_device->readSignals(names)->front();
    }

    /// A signal sampled at 1 kHz.
    std::vector<double> samples(const std::string& name, double duration_s) {
        std::vector<double> values;
        EXPECT_TRUE(m_device->startStream({{name}, 1000.0}, [&](SampleBlockPtr block) {
            values.insert(values.end(), block->values.begin(), block->values.end());
        }));
        wait(duration_s);
        m_device->stopStream();
        EXPECT_FALSE(values.empty());
        return values;
    }

    double mean(const std::string& name, double duration_s) {
        const std::vector<double> values = samples(name, duration_s);
        return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
    }

    /// Largest minus smallest value.
    double spread(const std::string& name, double duration_s) {
        const std::vector<double> values = samples(name, duration_s);
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        return *high - *low;
    }

    Device& device() { return *m_device; }

private:
    std::unique_ptr<Device> m_device;
};

TEST(Chain, steadySpeedsAreThoseOfTheForceBalance) {
    // Ideal chain: (phi I - K_f)/c to the board's single precision of the current (1e-7 relative).
    Motor motor("chain=ideal");
    motor.arm(BoardMode::Current);
    for (const double current_A : {2.0, 3.0, -3.0, 4.0}) {
        motor.set("hb.setpoint", current_A);
        motor.wait(15.0);
        const double expected = (1.43e-2 * std::fabs(current_A) - 2.05e-2) / 1.23e-3;
        EXPECT_NEAR(motor.signal("truth.speed"), std::copysign(expected, current_A), 1e-6 * expected);
    }
}

TEST(Chain, commutationAtTheFastLoopCostsAlmostNothing) {
    // Section 3.8: 284.8 r/min at 4 A with 1 kHz, 278.2 with 100 Hz commutation (figure 10: 284.93).
    Motor fast("imperfections=off");
    fast.arm(BoardMode::Current);
    fast.set("hb.setpoint", 4.0);
    fast.wait(5.0);
    EXPECT_NEAR(radPerSecondToRpm(fast.mean("truth.speed", 2.0)), 284.8, 0.1);
    Motor slow("imperfections=off");
    slow.set("commutation.divider", 10.0);
    slow.arm(BoardMode::Current);
    slow.set("hb.setpoint", 4.0);
    slow.wait(5.0);
    EXPECT_NEAR(radPerSecondToRpm(slow.mean("truth.speed", 2.0)), 278.2, 0.3);
}

TEST(Chain, strayFieldAdvancesTheAngleAsDerived) {
    // Property 7 of section 10: atan(k_s I/B0) = 3.64 deg at 4 A of torque current, 0 of d-axis current; to
    // the quantisation's 0.1 deg.
    Motor motor("imperfections=off&stray_mT_per_A=2.5&Kf=1&psi0=0.7"); // friction holds the rotor
    motor.set("stray.enabled", 0.0);
    motor.arm(BoardMode::Current);
    motor.set("hb.setpoint", 1.0);
    motor.wait(0.5);
    EXPECT_NEAR(radiansToDegrees(motor.mean("position", 0.2) - 0.7), 0.91, 0.15);
    motor.set("hb.setpoint", 0.0);
    ASSERT_TRUE(motor.device().disarm());
    motor.arm(BoardMode::DAxis);
    motor.set("hb.setpoint", 4.0);
    motor.wait(0.5);
    EXPECT_NEAR(radiansToDegrees(motor.mean("position", 0.2) - 0.7), 0.0, 0.1);
    EXPECT_EQ(motor.signal("truth.position"), 0.7);
}

TEST(Chain, compensationRemovesTheStrayField) {
    Motor motor("imperfections=off&stray_mT_per_A=2.5&Kf=1&psi0=0.7");
    motor.arm(BoardMode::Current);
    motor.set("hb.setpoint", 4.0);
    motor.wait(0.5);
    EXPECT_NEAR(radiansToDegrees(motor.mean("position", 0.2) - 0.7), 0.0, 0.1);
}

TEST(Chain, uncompensatedStrayFieldLowersTheGainAndLimitsIt) {
    // Section 6.10: kappa = k_s/B0 = 0.0159 rad/A feeds the current back into the angle. 10 A/rad act like
    // 10/(1 + 10 kappa) = 8.63; above 1/kappa = 62.8 A/rad the current alternates from sample to sample.
    Motor motor("imperfections=off&stray_mT_per_A=2.5&Kf=1&psi0=0.7"); // friction holds the rotor
    motor.set("stray.enabled", 0.0);
    motor.set("gain.ki", 0.0);
    motor.arm(BoardMode::Position);
    motor.set("hb.setpoint", 0.2);
    motor.wait(0.5);
    EXPECT_NEAR(motor.mean("current_command", 0.2), 8.63 * 0.2, 10.0 * 0.0025); // one ADC code, 0.0025 rad
    motor.set("gain.kp", 30.0);
    motor.set("hb.setpoint", 0.02);
    motor.wait(0.5);
    EXPECT_LT(motor.spread("current_command", 0.2), 3 * 30.0 * 0.0025); // settles but for some ADC codes
    motor.set("gain.kp", 100.0);
    motor.set("hb.setpoint", 0.03); // the push beyond one code that starts it
    motor.wait(0.5);
    EXPECT_GT(motor.spread("current_command", 0.2), 4.0);
}

TEST(Chain, positionFollowsTruthOverManyTurnsFromAnyStart) {
    for (const char* start : {"0", "3.14159265", "-3.14159265", "10", "-25"}) {
        Motor motor(std::string("imperfections=off&psi0=") + start);
        motor.arm(BoardMode::Current);
        motor.set("hb.setpoint", 3.5);
        motor.wait(10.0);
        motor.set("hb.setpoint", 0.0);
        motor.wait(2.0);
        EXPECT_GT(motor.signal("truth.position"), 100.0);
        EXPECT_NEAR(motor.signal("position"), motor.signal("truth.position"), degreesToRadians(0.2)) << start;
    }
}

TEST(Chain, restIsBitIdenticalWhileHoldingBelowBreakaway) {
    Motor motor("psi0=0.4");
    motor.arm(BoardMode::Current);
    motor.set("hb.setpoint", 1.2);
    const double before_rad = motor.signal("truth.position");
    motor.wait(5.0);
    EXPECT_EQ(motor.signal("truth.position"), before_rad);
    EXPECT_EQ(motor.signal("truth.speed"), 0.0);
}

TEST(Chain, coilTripsAtItsLimit) {
    Motor motor("imperfections=off&thermal_acceleration=10&Kf=1"); // held: 80 degC after 71 s, here 7.1 s
    motor.arm(BoardMode::Current);
    motor.set("hb.setpoint", 4.0);
    const auto stopped = motor.device().clock().waitFor(20.0);
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().code, ErrorCode::SafetyStop);
    EXPECT_NEAR(motor.device().clock().now_s(), 7.1, 0.4); // status is asked for every 0.25 s
    EXPECT_EQ(motor.device().state().fault, 1U);
    EXPECT_EQ(motor.signal("current.b"), 0.0);
}

TEST(Chain, aGeneratorRestartedWhileItRunsDrawsFrictionAnew) {
    // One plateau started twice without a rest in between: the segment is 1 all the time, yet it is a new
    // plateau. Speeds of two draws of 20 % differ by more than the 0.1 % that five time constants leave.
    Motor motor("imperfections=off&friction_scatter=0.2&seed=3");
    motor.arm(BoardMode::Current);
    for (const auto& [name, value] : {std::pair{"reference.shape", 7.0},
                                      {"plateau.dwell", 20.0},
                                      {"plateau.count", 1.0},
                                      {"plateau.current_1", 3.0}}) {
        motor.set(name, value);
    }
    motor.set("reference.start", 1.0);
    motor.wait(4.0);
    const double first_rad_s = motor.mean("truth.speed", 0.2);
    motor.wait(1.0);
    EXPECT_NEAR(motor.mean("truth.speed", 0.2) / first_rad_s, 1.0, 1e-3);
    motor.set("reference.start", 1.0);
    motor.wait(4.0);
    EXPECT_EQ(motor.signal("reference.segment"), 1.0);
    EXPECT_GT(std::fabs(motor.mean("truth.speed", 0.2) / first_rad_s - 1.0), 0.01);
}

TEST(Chain, setsOfGainsNeverMix) {
    Motor motor("seed=1");
    motor.arm(BoardMode::Position);
    for (int i = 0; i < 1000; ++i) {
        const double gain = i % 2 == 0 ? 8.0 : 10.0;
        const ParameterValue set[] = {
            {"gain.kp", gain}, {"gain.ki", gain / 100.0}, {"feedforward.viscous", gain / 200.0}};
        ASSERT_TRUE(motor.device().writeParameters(set));
        motor.wait(0.001 * (i % 4));
    }
    EXPECT_EQ(motor.signal("torn_count"), 0.0);
}

} // namespace
} // namespace halbench::devices
