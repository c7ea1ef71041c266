#include "control/analysis/margins.h"
#include "control/base/units.h"
#include "control/design/tuning_rules.h"
#include "control/lti/dead_time.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>

namespace halbench::control {
namespace {

TransferFunction continuous(Polynomial numerator, Polynomial denominator) {
    return *TransferFunction::make(std::move(numerator), std::move(denominator), TimeBase::continuous());
}

/// (K_P + K_I/s) process exp(-s dead time)
DeadTimeSystem loopOf(const PidGains& gains, const LaggedProcess& process) {
    const PidGains parallel = *convert(gains, PidForm::Parallel, GainUnit::PerRadian);
    const Polynomial slow =
        process.isIntegrating ? Polynomial{1.0, 0.0} : Polynomial{process.timeConstant_s, 1.0};
    const auto plant = continuous({process.gain}, slow);
    const auto controller = continuous({parallel.proportional, parallel.integral}, {1.0, 0.0});
    return *DeadTimeSystem::make(*series(controller, plant), process.deadTime_s);
}

// Skogestad 2003, table 1: with closedTime = deadTime a lag gets GM 3.14, PM 61.4 deg, Ms 1.59, an
// integrating process GM 2.96, PM 46.9 deg, Ms 1.70. Half of the last printed digit.
TEST(Simc, hasTheMarginsOfItsPaper) {
    const LaggedProcess lag{2.0, 3.0, 0.0, 1.0, false};
    const auto lagMargins = smallestMargins(loopOf(*simcGains(lag, 1.0), lag));
    EXPECT_NEAR(lagMargins.gainMargin_ratio, 3.14, 0.005);
    EXPECT_NEAR(lagMargins.phaseMargin_deg, 61.4, 0.05);
    EXPECT_NEAR(sensitivityPeaks(loopOf(*simcGains(lag, 1.0), lag)).Ms_ratio, 1.59, 0.005);
    const LaggedProcess integrating{0.5, 0.0, 0.0, 1.0, true};
    const auto loop = loopOf(*simcGains(integrating, 1.0), integrating);
    EXPECT_NEAR(smallestMargins(loop).gainMargin_ratio, 2.96, 0.005);
    EXPECT_NEAR(smallestMargins(loop).phaseMargin_deg, 46.9, 0.05);
    EXPECT_NEAR(sensitivityPeaks(loop).Ms_ratio, 1.70, 0.005);
}

TEST(Simc, aLongSecondLagIsTakenAsAnIntegration) {
    // Where both rules meet, secondTime = 4 (closedTime + deadTime), they agree; beyond, K T_d grows no more.
    const LaggedProcess at{1.0, 0.0, 0.4, 0.05, true};
    const auto meeting = simcGains(at, 0.05);
    ASSERT_TRUE(meeting.has_value());
    EXPECT_NEAR(meeting->derivative, 0.4, 1e-15);
    EXPECT_NEAR(meeting->proportional, 10.0, 1e-12);
    const LaggedProcess beyond{1.0, 0.0, 4.0, 0.05, true};
    const auto slow = simcGains(beyond, 0.05);
    EXPECT_NEAR(slow->derivative, 0.4, 1e-15);
    EXPECT_NEAR(slow->proportional, 100.0, 1e-11); // 1/(4 k'' (closedTime + deadTime)^2), k'' = 1/4
}

// The published motor, tight: a real position loop with integral action and room to spare.
TEST(Simc, tunesTheMotor) {
    const PositionPlant motor{1.23e-3 / 5.5e-4, 26.0, 0.0};
    for (const int delay : {0, 1, 2}) {
        const LoopTiming timing{0.01, delay};
        const auto process = laggedProcess(motor, timing);
        ASSERT_TRUE(process.has_value());
        EXPECT_DOUBLE_EQ(process->deadTime_s, 0.01 * (0.5 + delay));
        const auto gains = simcGains(*process, 2.0 * process->deadTime_s + 0.01);
        const auto loop = sampledOpenLoop(motor, *gains, timing);
        ASSERT_TRUE(loop.has_value());
        EXPECT_LT(poleRadius(*loop), 1.0);
        EXPECT_GT(smallestMargins(*loop).phaseMargin_deg, 25.0) << delay;
    }
    EXPECT_EQ(laggedProcess({0.0, 26.0, 0.0}, {0.01, 0}).error().code, ErrorCode::OutOfRange);
}

// Without dead time the lag is cancelled and the loop is exactly 1/(lambda s).
TEST(Lambda, makesAFirstOrderLoopOfItsTimeConstant) {
    const LaggedProcess process{2.0, 3.0, 0.0, 0.0, false};
    const auto loop = loopOf(*lambdaGains(process, 0.7), process);
    for (const double w : {0.1, 1.0, 10.0}) {
        EXPECT_LT(std::abs(loop.atFrequency(w) - 1.0 / std::complex<double>(0.0, 0.7 * w)), 1e-13 / w);
    }
    EXPECT_EQ(lambdaGains({std::nan(""), 1.0, 0.0, 1.0, false}, 1.0).error().code, ErrorCode::NotFinite);
    EXPECT_EQ(simcGains({0.0, 1.0, 0.0, 1.0, false}, 1.0).error().code, ErrorCode::OutOfRange);
}

// With the dead time as 1 - deadTime s the closed loop of an integrating process has (lambda s + 1)^2 below
// it: exactly, because the controller cancels the lag.
TEST(Lambda, makesTwoEqualLagsOfAnIntegratingProcess) {
    const LaggedProcess process{2.0, 0.0, 0.4, 0.05, true};
    const PidGains pid = *convert(*lambdaGains(process, 0.3), PidForm::Parallel, GainUnit::PerRadian);
    for (const double w : {0.1, 1.0, 10.0, 100.0}) {
        const std::complex<double> s(0.0, w);
        const auto controller = pid.proportional + pid.integral / s + pid.derivative * s;
        const auto loop = controller * 2.0 * (1.0 - 0.05 * s) / (s * (0.4 * s + 1.0));
        const auto expected =
            (1.0 - 0.05 * s) * (1.0 + (2.0 * 0.3 + 0.05) * s) / ((0.3 * s + 1.0) * (0.3 * s + 1.0));
        EXPECT_LT(std::abs(loop / (1.0 + loop) - expected), 1e-12 * std::abs(expected));
    }
}

// 1/(s + 1)^3 swings at w = sqrt 3 with a gain of 8.
TEST(ZieglerNichols, startsFromTheUltimatePoint) {
    const auto ultimate = ultimatePoint(continuous({1.0}, {1.0, 3.0, 3.0, 1.0}));
    ASSERT_TRUE(ultimate.has_value());
    EXPECT_NEAR(ultimate->gain, 8.0, 1e-10);
    EXPECT_NEAR(ultimate->period_s, 2.0 * Pi / std::sqrt(3.0), 1e-10);
    const PidGains pid = zieglerNicholsGains(*ultimate, ControllerKind::Pid);
    EXPECT_EQ(pid.form, PidForm::Standard);
    EXPECT_NEAR(pid.proportional, 4.8, 1e-10);
    EXPECT_NEAR(pid.integral, 0.5 * ultimate->period_s, 1e-12);
    EXPECT_NEAR(pid.derivative, 0.125 * ultimate->period_s, 1e-12);
    EXPECT_NEAR(zieglerNicholsGains(*ultimate, ControllerKind::Pi).integral, ultimate->period_s / 1.2, 1e-12);
    EXPECT_EQ(zieglerNicholsGains(*ultimate, ControllerKind::P).integral,
              std::numeric_limits<double>::infinity());
    EXPECT_EQ(ultimatePoint(continuous({1.0}, {1.0, 1.0})).error().code, ErrorCode::Refused);
}

// help: htm-theory.md 5: the sampled motor's ultimate gains are its stability limits.
TEST(ZieglerNichols, theMotorsUltimateGainIsItsSampledLimit) {
    const PositionPlant motor{1.23e-3 / 5.5e-4, 26.0, 0.0};
    EXPECT_NEAR(ultimatePoint(sampledPlant(motor, 0.01))->gain, 17.27, 0.01);
}

// A relay of 2 with hysteresis 0.1 that makes a swing of 0.5.
TEST(ZieglerNichols, aRelayExperimentGivesTheDescribingFunction) {
    const auto ultimate = ultimatePoint(2.0, 0.1, 0.5, 0.8);
    ASSERT_TRUE(ultimate.has_value());
    EXPECT_NEAR(ultimate->gain, 8.0 / (Pi * std::sqrt(0.24)), 1e-12);
    EXPECT_EQ(ultimatePoint(2.0, 0.5, 0.5, 0.8).error().code, ErrorCode::OutOfRange);
}

} // namespace
} // namespace halbench::control
