#include "control/base/units.h"
#include "control/signals/angle_wrap.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::control {
namespace {

/// There and back through some turns, at up to 12 rad/s in 100 rows a second.
std::vector<double> motion() {
    std::vector<double> angle_rad;
    for (int row = 0; row < 2000; ++row) {
        angle_rad.push_back(12.0 * std::sin(0.01 * row) + 0.3);
    }
    return angle_rad;
}

std::vector<double> wrapped(const std::vector<double>& angle_rad, double from_rad, double turn_rad) {
    std::vector<double> result;
    for (const double angle : angle_rad) {
        result.push_back(angle - turn_rad * std::floor((angle - from_rad) / turn_rad));
    }
    return result;
}

TEST(AngleWrap, aMotionOverSomeTurnsIsPutTogetherAgain) {
    const std::vector<double> whole = motion();
    struct Wrap {
        double from_rad;
        double turn_rad;
    };
    for (const Wrap& wrap : {Wrap{0.0, 2.0 * Pi}, Wrap{-Pi, 2.0 * Pi}, Wrap{-4.0, 4.0 * Pi}}) {
        std::vector<double> angle_rad = wrapped(whole, wrap.from_rad, wrap.turn_rad);
        const double shift_rad = angle_rad[0] - whole[0];
        const auto turn_rad = unwrapAngle(angle_rad);
        ASSERT_TRUE(turn_rad) << wrap.from_rad;
        EXPECT_NEAR(*turn_rad, wrap.turn_rad, 1e-12);
        for (std::size_t row = 0; row < whole.size(); ++row) {
            ASSERT_NEAR(angle_rad[row] - shift_rad, whole[row], 1e-11) << row; // some turns are rounded
        }
    }
}

TEST(AngleWrap, whatDoesNotWrapStaysAsItIs) {
    for (std::vector<double> angle_rad :
         {motion(), std::vector<double>{}, std::vector<double>{0.0, 2.0 * Pi, 0.0, 40.0}, // steps, no turn
          std::vector<double>(5, 1.0)}) {
        const std::vector<double> before = angle_rad;
        EXPECT_FALSE(unwrapAngle(angle_rad));
        EXPECT_EQ(angle_rad, before);
    }
}

TEST(AngleWrap, aTurnInSmallStepsIsNoWrap) {
    std::vector<double> angle_rad;
    for (int row = 0; row <= 100; ++row) {
        angle_rad.push_back(2.0 * Pi * row / 100.0);
    }
    const std::vector<double> before = angle_rad;
    EXPECT_FALSE(unwrapAngle(angle_rad));
    EXPECT_EQ(angle_rad, before);
}

} // namespace
} // namespace halbench::control
