#include "widgets/live_plot/axes/value_range.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::widgets {
namespace {

TEST(ValueRange, stepsAreOneTwoOrFiveTimesAPowerOfTen) {
    EXPECT_DOUBLE_EQ(niceStep(10.0, 10), 1.0);
    EXPECT_DOUBLE_EQ(niceStep(11.0, 10), 2.0);
    EXPECT_DOUBLE_EQ(niceStep(0.03, 10), 0.005);
    EXPECT_DOUBLE_EQ(niceStep(60.0, 10), 10.0);
}

TEST(ValueRange, ticksLieInsideAndOnTheEnds) {
    EXPECT_EQ(ticksOf({-1.0, 1.0}, 0.5), (std::vector<double>{-1.0, -0.5, 0.0, 0.5, 1.0}));
    EXPECT_EQ(ticksOf({0.1, 0.9}, 0.5), (std::vector<double>{0.5}));
    EXPECT_EQ(ticksOf({0.1, 0.3}, 0.1).size(), 3U); // though 0.3 is not three times 0.1 in doubles
}

TEST(ValueRange, ticksHaveTheDecimalsTheirDistanceNeeds) {
    EXPECT_EQ(tickText(0.5, decimalsOf(0.5)), "0.5");
    EXPECT_EQ(tickText(2.0, decimalsOf(0.05)), "2.00");
    EXPECT_EQ(tickText(-1e-17, decimalsOf(0.1)), "0.0");
    EXPECT_EQ(tickText(12345.0, decimalsOf(5.0)), "12345");
    EXPECT_EQ(tickText(2.5e-8, decimalsOf(5e-9)), "2.5e-8");
}

TEST(AutoRange, growsAtOnceToWholeStepsAroundTheData) {
    AutoRange axis(0.0);
    axis.update({-1.0, 1.0});
    EXPECT_TRUE(axis.range().contains({-1.0, 1.0}));
    axis.update({-1.0, 7.3});
    EXPECT_TRUE(axis.range().contains({-1.0, 7.3}));
    EXPECT_LT(axis.range().length(), 1.5 * 8.3); // and not much more
}

TEST(AutoRange, growsWhenItsSmallestLengthDoes) {
    AutoRange axis(0.1);
    axis.update({0.0, 0.14});
    EXPECT_LT(axis.range().length(), 1.0);
    axis.setSmallestLength(2.8);
    axis.update({0.0, 0.14});
    EXPECT_GE(axis.range().length(), 2.8);
    const ValueRange grown = axis.range();
    axis.update({0.0, 0.14});
    EXPECT_EQ(axis.range(), grown);
}

TEST(AutoRange, staysWhereItIsWhileTheDataFit) {
    AutoRange axis(0.0);
    axis.update({-1.0, 1.0});
    const ValueRange first = axis.range();
    for (int frame = 0; frame < 1000; ++frame) {
        const double size = 0.9 + 0.1 * std::sin(0.1 * frame);
        axis.update({-size, size});
        ASSERT_EQ(axis.range(), first);
    }
}

TEST(AutoRange, shrinksOnlyAfterThreeQuietSeconds) {
    AutoRange axis(0.0);
    axis.update({-100.0, 100.0});
    const ValueRange wide = axis.range();
    for (int frame = 0; frame < 89; ++frame) {
        axis.update({-1.0, 1.0});
        ASSERT_EQ(axis.range(), wide);
    }
    axis.update({-1.0, 1.0});
    EXPECT_LT(axis.range().length(), 5.0);
}

TEST(AutoRange, aPeakNowAndThenKeepsItWide) {
    AutoRange axis(0.0);
    for (int frame = 0; frame < 1000; ++frame) {
        axis.update(frame % 60 == 0 ? ValueRange{-100.0, 100.0} : ValueRange{-1.0, 1.0});
        ASSERT_GT(axis.range().length(), 200.0);
    }
}

TEST(AutoRange, doesNotMagnifyTheFlickerOfTheLastDigit) {
    AutoRange axis(0.01);
    axis.update({5.0, 5.0});
    EXPECT_GE(axis.range().length(), 0.01);
    EXPECT_TRUE(axis.range().contains({5.0, 5.0}));
    AutoRange constant(0.0);
    constant.update({0.0, 0.0});
    EXPECT_GT(constant.range().length(), 0.0);
}

TEST(AutoRange, fitTakesTheRoomBackAtOnce) {
    AutoRange axis(0.0);
    axis.update({-100.0, 100.0});
    axis.fit({-1.0, 1.0});
    EXPECT_LT(axis.range().length(), 5.0);
}

} // namespace
} // namespace halbench::widgets
