#include "app/actuators/planar/motion_windows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace halbench::app {
namespace {

PlatenMotion motionOf(std::size_t rows) {
    PlatenMotion motion;
    auto layout = std::make_shared<StreamLayout>();
    layout->period_s = 1e-3;
    motion.recording.layout = layout;
    for (std::size_t n = 0; n < rows; ++n) {
        motion.recording.time_s.push_back(1e-3 * static_cast<double>(n));
        motion.current_A.push_back(models::CoilCurrents_A::Constant(0.1));
    }
    return motion;
}

TEST(MotionWindows, integratesAPolynomialAsItsDerivativesSay) {
    // x = c + v t + a t^2/2: the weak form of its acceleration is a times the integral of the function, that
    // of its speed the integral of (v + a t) with it; no noise, so only the rule of the trapezium remains,
    // whose error is that of the end slopes, dt^2/12 w'' x' = 1e-6/12 * 120 * 0.2.
    constexpr double Start_m = 0.01, Speed_m_s = 0.05, Acceleration_m_s2 = 0.4;
    PlatenMotion motion = motionOf(900);
    std::vector<models::PlanarPose> poses;
    for (const double t : motion.recording.time_s) {
        poses.push_back({Start_m + Speed_m_s * t + 0.5 * Acceleration_m_s2 * t * t, 0.0, 0.0});
    }
    const MotionWindows integrated = integrateWindows(motion, poses, models::PlanarGeometry{}, {});
    ASSERT_EQ(integrated.windows.size(), 2U);
    EXPECT_EQ(integrated.leftOut, 0);
    const Moments& plain = integrated.windows[0].moments[0];
    EXPECT_NEAR(plain.one, 0.2, 1e-12); // mean 1/2 of sin^2 over 0.4 s
    EXPECT_NEAR(plain.acceleration.x(), Acceleration_m_s2 * 0.2, 3e-6);
    const double middle_s = 0.02 + 0.2; // the function is even about the middle of the window
    EXPECT_NEAR(plain.speed.x(), (Speed_m_s + Acceleration_m_s2 * middle_s) * 0.2, 3e-6);
    for (int f = 1; f < WindowFunctions; ++f) {
        const Moments& moments = integrated.windows[0].moments[static_cast<std::size_t>(f)];
        // Of the sines the third derivative at the ends is 3 w'' times 2 pi l/T: dt^2/12 * 370 * 47 * 0.055.
        EXPECT_NEAR(moments.acceleration.x(), Acceleration_m_s2 * moments.one, 1e-4) << f;
        EXPECT_EQ(moments.acceleration.y(), 0.0);
    }
}

TEST(MotionWindows, aWindowHasNoErrorsOfExactPosesAndLeavesOutMissingRows) {
    PlatenMotion motion = motionOf(1300);
    for (std::size_t n = 600; n < motion.recording.time_s.size(); ++n) {
        motion.recording.time_s[n] += 2e-3;
    }
    const std::vector<models::PlanarPose> poses(motion.recording.time_s.size());
    const MotionWindows integrated = integrateWindows(motion, poses, models::PlanarGeometry{}, {});
    EXPECT_EQ(integrated.leftOut, 1);
    ASSERT_FALSE(integrated.windows.empty());
    EXPECT_TRUE(integrated.windows.front().errors.empty());
}

TEST(MotionWindows, windowsWithoutCurrentAreNone) {
    PlatenMotion motion = motionOf(900);
    for (models::CoilCurrents_A& current_A : motion.current_A) {
        current_A.setZero();
    }
    const std::vector<models::PlanarPose> poses(motion.recording.time_s.size());
    EXPECT_TRUE(integrateWindows(motion, poses, models::PlanarGeometry{}, {}).windows.empty());
}

} // namespace
} // namespace halbench::app
