#include "control/law/board_law_run.h"

#include <gtest/gtest.h>

namespace halbench::control {
namespace {

// u = Kp e + x + Kd (r' - (psi - psi_before)/Ts), x' = Ts Ki e: by hand, htm-theory.md 3.6 and 8.4.
TEST(BoardLawRun, asksForTheCurrentOfTheTheory) {
    SampledPositionLaw law;
    law.kp_A_per_rad = 10.0;
    law.ki_A_per_rad_s = 5.0;
    law.kd_As_per_rad = 0.5;
    BoardLawRun<double> state(law);
    EXPECT_DOUBLE_EQ(state.step({0.1, 0.0, 0.0}, 0.0), 1.0);
    const double second_A = 10.0 * 0.08 + 0.01 * 5.0 * 0.1 - 0.5 * 0.02 / 0.01;
    EXPECT_DOUBLE_EQ(state.step({0.1, 0.0, 0.0}, 0.02), second_A);
}

TEST(BoardLawRun, staysWithinItsLimitAndStopsIntegratingThere) {
    SampledPositionLaw law;
    law.ki_A_per_rad_s = 50.0;
    BoardLawRun<double> state(law);
    for (int i = 0; i < 10; ++i) {
        EXPECT_DOUBLE_EQ(state.step({2.0, 0.0, 0.0}, 0.0), law.limit_A);
    }
    EXPECT_DOUBLE_EQ(state.step({0.0, 0.0, 0.0}, 0.0), 0.0) << "nothing was wound up";
}

TEST(BoardLawRun, hasItsCurrentLaterByItsDelay) {
    SampledPositionLaw law;
    law.ki_A_per_rad_s = 0.0;
    law.delaySamples = 2;
    BoardLawRun<double> state(law);
    EXPECT_DOUBLE_EQ(state.step({0.1, 0.0, 0.0}, 0.0), 0.0);
    EXPECT_DOUBLE_EQ(state.step({0.2, 0.0, 0.0}, 0.0), 0.0);
    EXPECT_DOUBLE_EQ(state.step({0.3, 0.0, 0.0}, 0.0), 1.0);
}

} // namespace
} // namespace halbench::control
