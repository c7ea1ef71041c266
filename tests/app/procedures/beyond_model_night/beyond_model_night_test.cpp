#include "tests/app/procedures/beyond_model/bad_amplifier.h"

namespace halbench::app {
namespace {

// Three standard errors are left by 0.27 % of 600 values, 1.6 of them; five or more once in forty times
// (Poisson).
TEST(IdentifyBeyondTheModel, isRightOrNotGoodFor200Motors) {
    EXPECT_LE(countWrongAndGood(1, 200), 4);
}

// The same. What takes less than the friction's scatter of 3.3 % from the torque is not seen: of the size of
// a dead zone of 0.07 A at 4 A.
TEST(IdentifyOnABadAmplifierNight, isRightOrNotGoodForTwoHundred) {
    EXPECT_LE(countWrongAndGoodOnBadAmplifiers(0, 199), 4);
}

} // namespace
} // namespace halbench::app
