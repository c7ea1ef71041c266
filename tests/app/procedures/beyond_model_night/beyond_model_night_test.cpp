#include "tests/app/procedures/beyond_model/bad_amplifier.h"

namespace halbench::app {
namespace {

// Three standard errors are left by 0.27 % of 600 values, 1.6 of them; five or more once in forty times
// (Poisson).
TEST(IdentifyBeyondTheModel, isRightOrNotGoodFor200Motors) {
    EXPECT_LE(countWrongAndGood(1, 200), 4);
}

TEST(IdentifyOnABadAmplifierNight, isRightOrNotGoodForTwoHundred) {
    EXPECT_EQ(countWrongAndGoodOnBadAmplifiers(0, 199), 0);
}

} // namespace
} // namespace halbench::app
