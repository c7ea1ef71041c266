#include "control/law/shaped_controller.h"
#include "tests/control/shaped_example.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

namespace halbench::control {
namespace {

// The same sums in the same order: not a digit may differ.
TEST(ShapedController, manyInStepAreTheSameAsEachAlone) {
    using Three = Eigen::Array<double, 3, 1>;
    const auto equation = ShapedEquation::make(shaped(), 0.01);
    ASSERT_TRUE(equation) << equation.error().message;
    ShapedRun<Three> together(*equation, Three::Zero());
    std::vector<ShapedController> alone(3, *ShapedController::make(shaped(), 0.01));
    for (int sample = 0; sample < 200; ++sample) {
        Three angle_rad;
        for (int i = 0; i < 3; ++i) {
            angle_rad[i] = (1.0 + 0.1 * i) * (1.0 - std::exp(-0.02 * sample)) + 0.01 * std::sin(0.7 * sample);
        }
        const Three current_A = together.step(1.0, angle_rad);
        for (int i = 0; i < 3; ++i) {
            EXPECT_EQ(current_A[i], alone[static_cast<std::size_t>(i)].step(1.0, angle_rad[i])) << sample;
        }
    }
}

TEST(ShapedController, aLawThatIsNotPossibleHasNone) {
    ShapedLaw law = shaped();
    law.proportionalWeight = 2.0;
    EXPECT_EQ(ShapedEquation::make(law, 0.01).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(ShapedController::make(law, 0.01).error().code, ErrorCode::OutOfRange);
}

} // namespace
} // namespace halbench::control
