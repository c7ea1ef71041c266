#include "control/assess/filtered_loop.h"
#include "control/robustness/filtered_robustness.h"
#include "tests/control/filtered_example.h"
#include "tests/control/published_motor.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::control {
namespace {

constexpr LoopTiming OneLate{0.01, 1};

UncertainPlant uncertain() {
    UncertainPlant result;
    result.mean = Eigen::Vector2d(2.2363636, 26.0);
    result.covariance = Eigen::MatrixXd::Zero(2, 2);
    result.covariance(1, 1) = std::pow(26.0 * 0.1, 2);
    result.toPlant = [](const Eigen::VectorXd& p) { return PositionPlant{p(0), p(1), 1.4336}; };
    return result;
}

// The same draws, judged one by one and all together: what each finds it narrows to rounding.
TEST(FilteredRobustness, withNothingFilteredFaresAsTheBoardsLawOverTheDraws) {
    const auto board = assessRobustness(uncertain(), lively(), OneLate, 1000, Random(3));
    const auto own = assessFiltered(uncertain(), of(lively()), OneLate, 1000, Random(3));
    ASSERT_TRUE(board && own);
    EXPECT_EQ(own->draws, board->draws);
    EXPECT_EQ(own->unstable_fraction, board->unstable_fraction);
    EXPECT_NEAR(*own->gainMargin_ratio_p5 / *board->gainMargin_ratio_p5, 1.0, 1e-6);
    EXPECT_NEAR(*own->phaseMargin_deg_p5 / *board->phaseMargin_deg_p5, 1.0, 1e-6);
    ASSERT_TRUE(own->modulusMargin && board->modulusMargin);
    EXPECT_NEAR(own->modulusMargin->p5 / board->modulusMargin->p5, 1.0, 1e-6);
}

// At the limit of K_P half of the motors are stronger than the loop bears.
TEST(FilteredRobustness, halfOfTheMotorsAreUnstableAtTheLimit) {
    FilteredLaw law;
    law.filters = {LowPassFilter{150.0, 1}};
    law.gains.proportional = 1.0;
    law.gains.proportional =
        assessFilteredDesign(published(), law, NoDelay, 3.0)->proportionalLimit_A_per_rad;
    const auto robust = assessFiltered(uncertain(), law, NoDelay, 1000, Random(3));
    ASSERT_TRUE(robust);
    EXPECT_NEAR(robust->unstable_fraction, 0.5, 4.0 * 0.5 / std::sqrt(1000.0)); // 4 sigma of the counting
}

TEST(FilteredRobustness, badInputsAreRefused) {
    FilteredLaw law = filtered();
    law.proportionalWeight = 2.0;
    EXPECT_FALSE(assessFiltered(uncertain(), law, NoDelay, 1000, Random(3)));
    EXPECT_FALSE(assessFiltered(uncertain(), filtered(), NoDelay, 10, Random(3)));
}

} // namespace
} // namespace halbench::control
