#include "control/law/filtered_controller.h"
#include "tests/control/filtered_example.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

namespace halbench::control {
namespace {

// The same sums in the same order, but for the divisions by the period, which many at once take as products:
// a digit or two of 16 in a sum of some ten terms, of which the largest is some hundred amperes.
TEST(FilteredController, manyInStepAreTheSameAsEachAlone) {
    using Three = Eigen::Array<double, 3, 1>;
    const auto equation = lawEquation(filtered(), 0.01);
    ASSERT_TRUE(equation) << equation.error().message;
    LawRun<Three> together(*equation, Three::Zero());
    std::vector<FilteredController> alone(3, *FilteredController::make(filtered(), 0.01));
    for (int sample = 0; sample < 200; ++sample) {
        Three angle_rad;
        for (int i = 0; i < 3; ++i) {
            angle_rad[i] = (1.0 + 0.1 * i) * (1.0 - std::exp(-0.02 * sample)) + 0.01 * std::sin(0.7 * sample);
        }
        const Three current_A = together.step(1.0, angle_rad);
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(current_A[i], alone[static_cast<std::size_t>(i)].step(1.0, angle_rad[i]), 1e-11)
                << sample;
        }
    }
}

TEST(FilteredController, aLawThatIsNotPossibleHasNone) {
    FilteredLaw law = filtered();
    law.proportionalWeight = 2.0;
    EXPECT_EQ(lawEquation(law, 0.01).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(FilteredController::make(law, 0.01).error().code, ErrorCode::OutOfRange);
}

} // namespace
} // namespace halbench::control
