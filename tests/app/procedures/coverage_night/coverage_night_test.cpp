#include "tests/app/procedures/coverage/coverage.h"

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

} // namespace
} // namespace halbench::app
