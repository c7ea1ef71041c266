#include "control/identify/distributions.h"

#include <gtest/gtest.h>

#include <cmath>

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

TEST(Distributions, agreeWithThePrintedTablesOfFisherAndChiSquare) {
    EXPECT_NEAR(fisherTail(4.46, 2, 8), 0.05, 2e-4); // table to two decimals
    EXPECT_NEAR(fisherTail(3.14, 11, 9), 0.05, 2e-3);
    EXPECT_NEAR(chiSquareTail(3.841, 1), 0.05, 2e-5);
    EXPECT_NEAR(chiSquareTail(18.307, 10), 0.05, 2e-5);
    EXPECT_NEAR(chiSquareTail(2.0, 2), std::exp(-1.0), 1e-14);
    EXPECT_NEAR(chiSquareTail(40.0, 2), std::exp(-20.0), 1e-20);
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
