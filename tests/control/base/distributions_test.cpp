#include "control/base/distributions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace halbench::control {
namespace {

// Printed tables give three decimals: half a unit of the last digit.
constexpr double TableTolerance = 5.1e-4;

TEST(Distributions, agreeWithThePrintedTableOfStudentsT) {
    EXPECT_NEAR(studentQuantile(0.975, 1), 12.706, TableTolerance);
    EXPECT_NEAR(studentQuantile(0.975, 4), 2.776, TableTolerance);
    EXPECT_NEAR(studentQuantile(0.975, 11), 2.201, TableTolerance);
    EXPECT_NEAR(studentQuantile(0.95, 24), 1.711, TableTolerance);
    EXPECT_NEAR(studentQuantile(0.995, 60), 2.660, TableTolerance);
    EXPECT_NEAR(studentQuantile(0.025, 11), -2.201, TableTolerance);
}

TEST(Distributions, studentMeetsClosedFormsForOneAndTwoDegrees) {
    // one degree is Cauchy's distribution, two degrees have t = sqrt(2 u^2/(1 - u^2)), u = 2p - 1
    EXPECT_NEAR(studentQuantile(0.9, 1), std::tan(M_PI * 0.4), 1e-11);
    EXPECT_NEAR(studentQuantile(0.9, 2), std::sqrt(2.0 * 0.64 / (1.0 - 0.64)), 1e-11);
}

TEST(Distributions, studentOfInfiniteFreedomIsTheNormalDistribution) {
    constexpr double Infinite = std::numeric_limits<double>::infinity();
    EXPECT_NEAR(studentTwoSided(1.959963985, Infinite), 0.05, 1e-9); // printed table
    EXPECT_NEAR(studentTwoSided(-1.3, Infinite), std::erfc(1.3 / std::sqrt(2.0)), 1e-14);
}

TEST(Distributions, agreeWithThePrintedTablesOfFisherAndChiSquare) {
    EXPECT_NEAR(fisherTail(4.46, 2, 8), 0.05, 2e-4); // table to two decimals
    EXPECT_NEAR(fisherTail(3.14, 11, 9), 0.05, 2e-3);
    EXPECT_NEAR(chiSquareTail(3.841, 1), 0.05, 2e-5);
    EXPECT_NEAR(chiSquareTail(18.307, 10), 0.05, 2e-5);
    EXPECT_NEAR(chiSquareTail(2.0, 2), std::exp(-1.0), 1e-14);
    EXPECT_NEAR(chiSquareTail(40.0, 2), std::exp(-20.0), 1e-20);
}

TEST(Distributions, chiSquareQuantileInvertsItsTail) {
    EXPECT_NEAR(chiSquareQuantile(0.975, 10), 20.483, TableTolerance);
    EXPECT_NEAR(chiSquareQuantile(0.025, 10), 3.247, TableTolerance);
    // two degrees: P = 1 - exp(-x/2)
    EXPECT_NEAR(chiSquareQuantile(0.025, 2), -2.0 * std::log(0.975), 1e-13);
    EXPECT_NEAR(chiSquareTail(chiSquareQuantile(0.9, 33.3), 33.3), 0.1, 1e-13);
    // many degrees: Wilson and Hilferty's cube is good to some 1e-6 there
    const double spread = 2.0 / (9.0 * 2e4);
    EXPECT_NEAR(chiSquareQuantile(0.975, 2e4) / 2e4,
                std::pow(1.0 - spread + normalQuantile(0.975) * std::sqrt(spread), 3.0), 1e-6);
}

TEST(Distributions, normalQuantileInvertsItsProbability) {
    EXPECT_NEAR(normalQuantile(0.975), 1.959963984540054, 1e-12);
    EXPECT_NEAR(normalProbability(normalQuantile(0.123)), 0.123, 1e-14);
    EXPECT_EQ(normalQuantile(0.5), 0.0);
}

TEST(Distributions, incompleteBetaIsSymmetric) {
    EXPECT_NEAR(incompleteBeta(2.5, 7.0, 0.3) + incompleteBeta(7.0, 2.5, 0.7), 1.0, 1e-14);
    // I_x(2, 1) = x^2
    EXPECT_NEAR(incompleteBeta(2.0, 1.0, 0.6), 0.36, 1e-14);
}

} // namespace
} // namespace halbench::control
