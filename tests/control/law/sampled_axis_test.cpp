#include "control/law/sampled_axis.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::control {
namespace {

const PositionPlant Motor{1.23e-3 / 5.5e-4, 26.0, 0.0};

TEST(SampledAxis, sharesAreTheirClosedFormsWhereThoseHaveDigits) {
    for (const double x : {0.3, 0.49, 0.51, 2.0, 30.0, -0.4}) {
        EXPECT_NEAR(heldSpeedShare(x), (1.0 - std::exp(-x)) / x, 1e-15 * std::abs(1.0 / x) + 1e-15);
        // The closed form loses 2/x digits' worth of rounding to cancellation.
        EXPECT_NEAR(heldAngleShare(x), (x - 1.0 + std::exp(-x)) / (x * x), 1e-14);
    }
}

TEST(SampledAxis, sharesWithoutDampingAreOneAndOneHalf) {
    EXPECT_EQ(heldSpeedShare(0.0), 1.0);
    EXPECT_EQ(heldAngleShare(0.0), 0.5);
    EXPECT_NEAR(heldAngleShare(1e-9), 0.5 - 1e-9 / 6.0, 1e-16);
}

// help: htm-theory.md 3.1: w_inf + (w_0 - w_inf) e^(-a t) and its integral.
TEST(SampledAxis, movesAsTheClosedFormSays) {
    const double a = Motor.dampingRate_1_s;
    const double limit = 26.0 * 2.0 / a;
    const double t = 0.37;
    const RotorState end = advance(Motor, {1.0, 5.0}, 2.0, t);
    EXPECT_NEAR(end.speed_rad_s, limit + (5.0 - limit) * std::exp(-a * t), 1e-12);
    EXPECT_NEAR(end.angle_rad, 1.0 + limit * t + (5.0 - limit) * (1.0 - std::exp(-a * t)) / a, 1e-12);
}

TEST(SampledAxis, twoHalvesMakeAWhole) {
    const RotorState whole = advance(Motor, {0.2, -3.0}, 1.5, 0.02);
    const RotorState halves = advance(Motor, advance(Motor, {0.2, -3.0}, 1.5, 0.01), 1.5, 0.01);
    EXPECT_NEAR(whole.angle_rad, halves.angle_rad, 1e-15);
    EXPECT_NEAR(whole.speed_rad_s, halves.speed_rad_s, 1e-14);
}

} // namespace
} // namespace halbench::control
