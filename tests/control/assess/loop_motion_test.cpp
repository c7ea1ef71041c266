#include "control/assess/loop_motion.h"
#include "tests/control/published_motor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

/// psi'' + a psi' = k i from rest: psi = k i (t/a - (1 - e^-at)/a^2).
double pushed_rad(double current_A, double time_s) {
    const PositionPlant plant = published();
    const double a = plant.dampingRate_1_s;
    const double t = std::max(time_s, 0.0);
    return plant.accelerationGain_rad_s2_A * current_A * (t / a - (1.0 - std::exp(-a * t)) / (a * a));
}

TEST(LoopMotion, ofAConstantCurrentIsTheClosedFormAfterTheDelay) {
    int calls = 0;
    const auto motion = loopMotion(
        published(),
        [&calls](double reference_rad, double) {
            ++calls;
            return 2.0 * reference_rad;
        },
        {0.01, 2}, {0.5, 0.0}, 0.2, 4);
    ASSERT_TRUE(motion);
    ASSERT_EQ(motion->time_s.size(), 81U);
    EXPECT_EQ(calls, 21) << "once a sample, both ends";
    for (std::size_t i = 0; i < motion->time_s.size(); ++i) {
        const double t = motion->time_s[i];
        EXPECT_NEAR(t, 0.0025 * static_cast<double>(i), 1e-15);
        EXPECT_NEAR(motion->angle_rad[i], pushed_rad(1.0, t - 0.02), 1e-14) << t; // 80 exact steps
        EXPECT_EQ(motion->current_A[i], i < 8 ? 0.0 : 1.0) << t;
    }
}

TEST(LoopMotion, aLoadPushesFromTheFirstInstantBesideTheLaw) {
    const auto motion = loopMotion(
        published(), [](double, double) { return 0.0; }, {0.01, 1}, {0.0, 0.3}, 0.1, 1);
    ASSERT_TRUE(motion);
    EXPECT_NEAR(motion->angle_rad.back(), pushed_rad(0.3, 0.1), 1e-14);
    const LoadStep load = loadOf(*motion, 0.0);
    EXPECT_EQ(load.peak_rad, motion->angle_rad.back());
    EXPECT_FALSE(load.recoveryTime_s);
}

TEST(LoopMotion, whatCannotBeIsRefused) {
    const auto refusal = [](const MotionCause& cause, double duration_s, double gain) {
        const auto motion = loopMotion(
            published(), [gain](double, double angle_rad) { return gain * (1.0 + angle_rad); }, {0.01, 0},
            cause, duration_s, 1);
        return motion ? ErrorCode::Internal : motion.error().code;
    };
    EXPECT_EQ(refusal({0.0, 0.0}, 1.0, 1.0), ErrorCode::OutOfRange);
    EXPECT_EQ(refusal({1.0, 0.0}, -1.0, 1.0), ErrorCode::OutOfRange);
    EXPECT_EQ(refusal({1.0, 0.0}, 1e6, 1.0), ErrorCode::OutOfRange);
    EXPECT_EQ(refusal({1.0, 0.0}, 100.0, 1e6), ErrorCode::Refused) << "it grows beyond all numbers";
}

} // namespace
} // namespace halbench::control
