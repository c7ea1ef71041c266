#include "tests/app/procedures/coverage/coverage.h"

#include <cmath>

namespace halbench::app {
namespace {

TEST(IdentifyCoverage, intervalsHoldTheTruthIn92To98PercentOfSeeds1To500) {
    const Coverage coverage = countCoverage(1, 500);
    EXPECT_EQ(coverage.runs, 500);
    // acceptance of the identification: 92 to 98 % (95 % has sigma 1 point in 500 runs)
    for (const int covered : coverage.covered) {
        EXPECT_GE(covered, 460);
        EXPECT_LE(covered, 490);
    }
    EXPECT_LE(coverage.notGood, 25); // 5 % of motors that the model describes
}

// A gain error at the limit of the stated tolerance uses all of it; what is left has to hold the rest.
TEST(IdentifyCoverage, aStatedCurrentToleranceHoldsAGainErrorOfTheDriveOfThatSize) {
    constexpr int Least = 26; // of 30 at 95 %: fewer in one of 60 such tests
    for (const double error_percent : {-4.0, 1.0, 3.0, 5.0}) {
        const Coverage coverage = countCoverage(
            1, 30, "&dac_gain_error=" + std::to_string(0.01 * error_percent), std::fabs(error_percent));
        EXPECT_EQ(coverage.runs, 30);
        EXPECT_GE(coverage.covered[2], Least) << error_percent;
    }
}

} // namespace
} // namespace halbench::app
