#include "app/procedures/move/motion_envelope.h"
#include "control/base/units.h"
#include "tests/app/procedures/uncertain_motor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace halbench::app {
namespace {

MotionEnvelope level(double low_rad, double high_rad, std::size_t points) {
    MotionEnvelope band;
    for (std::size_t i = 0; i < points; ++i) {
        band.time_s.push_back(1e-3 * static_cast<double>(i * MotionEnvelopeStride));
    }
    band.angle_rad = {std::vector<double>(points, low_rad), std::vector<double>(points, high_rad)};
    return band;
}

TEST(MotionEnvelope, holdsNineTenthsOfTheMotions) {
    // Angles that are the motor's friction: normal with 1 and 0.033; 1.645 sigma at each side.
    const auto motors = drawRuns(uncertainMotor(0.02), {4000, 7});
    ASSERT_TRUE(motors) << motors.error().message;
    const MotionEnvelope band = motionEnvelope(
        *motors, 6, [](const RunMotor& motor) { return std::vector<double>(6, motor.friction_ratio); });
    ASSERT_EQ(band.time_s.size(), 2U);
    EXPECT_EQ(band.time_s[1], 0.005);
    // The 5th percentile of n draws is known to sqrt(0.05 0.95/n)/0.103 sigma: 0.033 sigma of 4000.
    EXPECT_NEAR(band.angle_rad.p5[0], 1.0 - 1.645 * 0.033, 3.0 * 0.033 * 0.033);
    EXPECT_NEAR(band.angle_rad.p95[1], 1.0 + 1.645 * 0.033, 3.0 * 0.033 * 0.033);
}

TEST(MotionEnvelope, theSameSeedDrawsTheSameMotors) {
    const auto one = drawRuns(uncertainMotor(0.02), {1000, 7});
    const auto same = drawRuns(uncertainMotor(0.02), {1000, 7});
    const auto other = drawRuns(uncertainMotor(0.02), {1000, 8});
    ASSERT_TRUE(one && same && other);
    EXPECT_EQ(one->front().friction_ratio, same->front().friction_ratio);
    EXPECT_EQ(one->back().plant.breakawayCurrent_A, same->back().plant.breakawayCurrent_A);
    EXPECT_NE(one->front().friction_ratio, other->front().friction_ratio);
    for (const RunMotor& motor : *one) {
        EXPECT_GE(motor.static_ratio, 1.0);
        EXPECT_LE(motor.static_ratio, MostStatic_ratio);
    }
}

TEST(MotionEnvelope, aMotorWithoutCovarianceHasNone) {
    MotorEstimate exact = uncertainMotor(0.02);
    exact.covarianceNames.clear();
    exact.covariance.clear();
    const auto motors = drawRuns(exact, {1000, 1});
    ASSERT_FALSE(motors);
    EXPECT_EQ(motors.error().code, ErrorCode::Refused);
}

TEST(MotionEnvelope, saysHowMuchWiderItWouldHaveToBe) {
    const MotionEnvelope band = level(-1.0, 1.0, 100);
    std::vector<double> seen(500, 0.5);
    EXPECT_DOUBLE_EQ(neededWidening_ratio(band, seen, 0.0), 0.5);
    EXPECT_DOUBLE_EQ(neededWidening_ratio(band, seen, 0.6), 0.0);
    std::fill(seen.begin(), seen.begin() + 20, 9.0); // 4 of 100 points do not count
    EXPECT_DOUBLE_EQ(neededWidening_ratio(band, seen, 0.0), 0.5);
    std::fill(seen.begin(), seen.begin() + 100, 9.0);
    EXPECT_DOUBLE_EQ(neededWidening_ratio(band, seen, 1.0), 8.0);
    seen[200] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(std::isinf(neededWidening_ratio(band, seen, 1.0))) << "what is no number is nowhere inside";
    EXPECT_TRUE(std::isinf(neededWidening_ratio(band, {}, 1.0)));
}

TEST(MotionEnvelope, isWidenedAboutItsMiddle) {
    const MotionEnvelope wider = widened(level(1.0, 3.0, 1), 2.0, 0.1);
    EXPECT_DOUBLE_EQ(wider.angle_rad.p5[0], 2.0 - 2.0 - 0.1);
    EXPECT_DOUBLE_EQ(wider.angle_rad.p95[0], 2.0 + 2.0 + 0.1);
}

} // namespace
} // namespace halbench::app
