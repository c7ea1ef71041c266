#include "control/base/unit_algebra.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench {
namespace {

using Values = std::vector<double>;

TEST(UnitAlgebraTest, powersFollowProductsQuotientsAndRoots) {
    EXPECT_EQ(unitOf([](const Values& x) { return x[0] * x[0]; }, {"A"}), "A^2");
    EXPECT_EQ(unitOf([](const Values& x) { return std::sqrt(x[0] * x[0] + x[1] * x[1]); }, {"T", "T"}), "T");
    EXPECT_EQ(unitOf([](const Values& x) { return x[0] / x[1]; }, {"rad", "s"}), "rad/s");
    EXPECT_EQ(unitOf([](const Values& x) { return x[0] / x[1] / x[1]; }, {"rad", "s"}), "rad/s^2");
    EXPECT_EQ(unitOf([](const Values& x) { return x[0] * x[1]; }, {"N*m/A", "A"}), "N*m");
    EXPECT_EQ(unitOf([](const Values& x) { return x[0] * x[1]; }, {"A/(rad*s)", "s"}), "A/rad");
    EXPECT_EQ(unitOf([](const Values& x) { return x[0] / (x[1] * x[2]); }, {"T", "A", "s"}), "T/(A*s)");
    EXPECT_EQ(unitOf([](const Values& x) { return 3.0 / x[0]; }, {"s"}), "1/s");
    EXPECT_EQ(unitOf([](const Values& x) { return x[0] * x[1]; }, {"m*s^-1", "s"}), "m");
    EXPECT_EQ(unitOf([](const Values& x) { return x[0] / x[1]; }, {"m^12", "m^2"}), "m^10");
    EXPECT_EQ(unitOf([](const Values& x) { return -2.5 * std::abs(x[0]); }, {"rad/s^2/A"}), "rad/s^2/A");
}

TEST(UnitAlgebraTest, aRatioIsANumber) {
    EXPECT_EQ(unitOf([](const Values& x) { return x[0] / x[1]; }, {"A", "A"}), "1");
    EXPECT_EQ(unitOf([](const Values& x) { return 2.0 * x[0]; }, {""}), "1");
}

TEST(UnitAlgebraTest, anAngleDropsOutWhereItMeansANumber) {
    EXPECT_EQ(unitOf([](const Values& x) { return std::sin(x[0]) * x[1]; }, {"rad", "A"}), "A");
    EXPECT_EQ(unitOf([](const Values& x) { return x[0] - x[1]; }, {"rad", "rad"}), "rad");
}

TEST(UnitAlgebraTest, aDifferenceOfTemperaturesIsInKelvin) {
    EXPECT_EQ(unitOf([](const Values& x) { return x[0] - x[1]; }, {"degC", "degC"}), "K");
    EXPECT_EQ(unitOf([](const Values& x) { return 0.5 * (x[0] + x[1]); }, {"degC", "degC"}), "degC");
    EXPECT_EQ(unitOf([](const Values& x) { return std::max(x[0], x[1]); }, {"degC", "degC"}), "degC");
    EXPECT_EQ(unitOf([](const Values& x) { return 2.0 * x[0]; }, {"degC"}), std::nullopt);
}

TEST(UnitAlgebraTest, whereNoUnitFollowsThereIsNone) {
    EXPECT_EQ(unitOf([](const Values& x) { return x[0] + x[1]; }, {"A", "T"}), std::nullopt);
    EXPECT_EQ(unitOf([](const Values& x) { return x[0] + 1.0; }, {"A"}), std::nullopt);
    EXPECT_EQ(unitOf([](const Values& x) { return std::exp(x[0]); }, {"A"}), std::nullopt);
    EXPECT_EQ(unitOf([](const Values& x) { return std::sqrt(x[0]); }, {"A"}), std::nullopt);
    EXPECT_EQ(unitOf([](const Values& x) { return x[0] > 1.0 ? 1.0 : 0.0; }, {"A"}), std::nullopt);
    EXPECT_EQ(unitOf([](const Values& x) { return x[0] < 0.0 ? x[1] : x[2]; }, {"A", "A", "T"}),
              std::nullopt);
    EXPECT_EQ(unitOf([](const Values& x) { return 0.0 * x[0]; }, {"A"}), std::nullopt);
}

} // namespace
} // namespace halbench
