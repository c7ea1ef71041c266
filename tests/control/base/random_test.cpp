#include "control/base/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench {
namespace {

TEST(Random, equalSeedsGiveEqualNumbers) {
    Random one(7);
    Random two(7);
    for (int i = 0; i < 100; ++i) {
        EXPECT_EQ(one.bits(), two.bits());
    }
}

TEST(Random, gaussianHasMomentsOfTheStandardNormal) {
    Random random(1);
    constexpr int Count = 200000;
    double sum = 0.0;
    double squares = 0.0;
    double fourth = 0.0;
    for (int i = 0; i < Count; ++i) {
        const double x = random.gaussian();
        sum += x;
        squares += x * x;
        fourth += x * x * x * x;
    }
    // Standard errors: mean 1/sqrt(n) = 0.0022, variance sqrt(2/n) = 0.0032, fourth moment sqrt(96/n) =
    // 0.022.
    EXPECT_NEAR(sum / Count, 0.0, 0.009);
    EXPECT_NEAR(squares / Count, 1.0, 0.013);
    EXPECT_NEAR(fourth / Count, 3.0, 0.09);
}

TEST(Random, forksAreIndependentOfHowMuchWasDrawnBefore) {
    Random fresh(3);
    Random used(3);
    used.gaussian();
    used.uniform();
    EXPECT_EQ(fresh.fork(5).bits(), used.fork(5).bits());
    EXPECT_NE(fresh.fork(5).bits(), fresh.fork(6).bits());
}

} // namespace
} // namespace halbench
