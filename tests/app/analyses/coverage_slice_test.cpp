#include "app/analyses/spherical/coverage_slice.h"
#include "control/base/units.h"
#include "models/spherical/coverage/placed_sensor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

// resources/help/spherical-theory.md section 6: where Theta vanishes at zero tilt.
const double Hole_rad = 0.5 * std::atan(std::sqrt(0.5));

models::CoverageModel published() {
    return models::coverageModelOf({}, models::publishedPlacement());
}

SliceOfCoverage sliceAt(HeldAngle held, double held_rad,
                        models::CoverageQuantity quantity = models::CoverageQuantity::LeastComponent_T) {
    CoverageSliceConfig config;
    config.quantity = quantity;
    config.held = held;
    config.held_rad = held_rad;
    const auto slice = coverageSlice(published(), config);
    EXPECT_TRUE(slice);
    return *slice;
}

// Section 6: within 7.5 degrees of alpha and 3.1 of beta, spins 13 ... 22 degrees.
TEST(CoverageSliceTest, theHoleLiesInTheMiddleOfItsSlice) {
    const SliceOfCoverage slice = sliceAt(HeldAngle::Gamma, Hole_rad);
    ASSERT_EQ(slice.least_T.size(), 91u * 91u);
    std::size_t uncovered = 0;
    for (int a = 0; a < 91; ++a) {
        for (int b = 0; b < 91; ++b) {
            if (slice.least_T[static_cast<std::size_t>(91 * a + b)] <= 0.01F) {
                ++uncovered;
                EXPECT_LE(std::abs(radiansToDegrees(slice.grid.alpha.at(a))), 7.6);
                EXPECT_LE(std::abs(radiansToDegrees(slice.grid.beta.at(b))), 3.2);
            }
        }
    }
    EXPECT_GT(uncovered, 0u);
    EXPECT_EQ(slice.uncovered, uncovered);
    EXPECT_NEAR(static_cast<double>(slice.least_T[91 * 45 + 45]), 0.0, 1e-9); // float of a Theta of zero
    EXPECT_EQ(sliceAt(HeldAngle::Gamma, degreesToRadians(10.0)).uncovered, 0u);
    EXPECT_EQ(sliceAt(HeldAngle::Gamma, degreesToRadians(25.0)).uncovered, 0u);
}

TEST(CoverageSliceTest, aHeldTiltShowsBothSpinsOfTheHole) {
    const SliceOfCoverage slice = sliceAt(HeldAngle::Alpha, 0.0);
    ASSERT_EQ(slice.least_T.size(), 91u * 180u); // beta by gamma
    bool isFirst = false;
    bool isSecond = false;
    for (std::size_t i = 0; i < slice.least_T.size(); ++i) {
        if (slice.least_T[i] <= 0.01F) {
            const double gamma_deg = radiansToDegrees(slice.grid.gamma.at(static_cast<int>(i % 180)));
            const bool isHere = gamma_deg > 12.5 && gamma_deg < 22.5;
            const bool isThere = gamma_deg > -77.5 && gamma_deg < -67.5;
            EXPECT_TRUE(isHere || isThere) << gamma_deg;
            isFirst = isFirst || isHere;
            isSecond = isSecond || isThere;
        }
    }
    EXPECT_TRUE(isFirst && isSecond);
}

// Section 7: the bound is 0.0237 degrees at the best pose and 0.0332 at the worst, at 100 uT, holes included.
TEST(CoverageSliceTest, thePredictedErrorIsThatOfTheTheoryInTheHoleToo) {
    const SliceOfCoverage slice =
        sliceAt(HeldAngle::Gamma, Hole_rad, models::CoverageQuantity::PredictedDeviation_rad);
    const auto [low, high] = std::minmax_element(slice.value.begin(), slice.value.end());
    EXPECT_GE(radiansToDegrees(static_cast<double>(*low)), 0.0237 - 5e-5);
    EXPECT_LE(radiansToDegrees(static_cast<double>(*high)), 0.0332 + 5e-5);
    EXPECT_GT(slice.uncovered, 0u);
}

TEST(CoverageSliceTest, namesTheCounterexamplesOfThePublishedPlacement) {
    const auto judgement = judgeCoverage(published(), 0.01);
    ASSERT_TRUE(judgement);
    EXPECT_FALSE(judgement->isProven);
    ASSERT_EQ(judgement->counterexamples.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        const Counterexample& one = judgement->counterexamples[i];
        EXPECT_EQ(one.component, 1);
        EXPECT_NEAR(one.at.alpha_rad, 0.0, 1e-8);
        EXPECT_NEAR(one.at.beta_rad, 0.0, 1e-8);
        EXPECT_NEAR(one.at.gamma_rad, i == 0 ? Hole_rad : Hole_rad - 0.5 * Pi, 1e-8);
        EXPECT_NEAR(one.largest_T, 0.0, 1e-9);
    }
}

TEST(CoverageSliceTest, theRecommendedPlacementIsProven) {
    const auto judgement = judgeCoverage(models::coverageModelOf({}, models::recommendedPlacement()), 0.01);
    ASSERT_TRUE(judgement);
    EXPECT_TRUE(judgement->isProven);
    EXPECT_TRUE(judgement->counterexamples.empty());
}

TEST(CoverageSliceTest, stopsWhenAsked) {
    const AnalysisControl control{[] { return true; }, {}};
    EXPECT_EQ(judgeCoverage(published(), 0.01, control).error().code, ErrorCode::Interrupted);
    EXPECT_EQ(coverageSlice(published(), {}, control).error().code, ErrorCode::Interrupted);
}

} // namespace
} // namespace halbench::app
