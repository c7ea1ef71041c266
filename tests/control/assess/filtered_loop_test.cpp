#include "control/assess/filtered_loop.h"
#include "control/base/units.h"
#include "control/law/filtered_controller.h"
#include "control/law/gain_limit.h"
#include "control/lti/responses.h"
#include "tests/control/filtered_example.h"
#include "tests/control/published_motor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

constexpr LoopTiming OneLate{0.01, 1};
constexpr double Limit_A = 3.0;

void expectSame(const LoopAssessment& one, const LoopAssessment& other) {
    EXPECT_EQ(one.isStable, other.isStable);
    EXPECT_EQ(one.poleRadius, other.poleRadius);
    EXPECT_EQ(one.poleRadiusOneSampleLater, other.poleRadiusOneSampleLater);
    EXPECT_EQ(one.margins.gainMargin_ratio, other.margins.gainMargin_ratio);
    EXPECT_EQ(one.margins.phaseMargin_deg, other.margins.phaseMargin_deg);
    EXPECT_EQ(one.margins.delayMargin_s, other.margins.delayMargin_s);
    EXPECT_EQ(one.margins.modulusMargin, other.margins.modulusMargin);
    EXPECT_EQ(one.peaks.Ms_ratio, other.peaks.Ms_ratio);
    EXPECT_EQ(one.peaks.Mt_ratio, other.peaks.Mt_ratio);
    EXPECT_EQ(one.noiseGain_A_per_rad, other.noiseGain_A_per_rad);
    EXPECT_DOUBLE_EQ(one.fastGain_A_per_rad, other.fastGain_A_per_rad);
    EXPECT_EQ(one.proportionalLimit_A_per_rad, other.proportionalLimit_A_per_rad);
    EXPECT_EQ(one.step.time_s, other.step.time_s);
    ASSERT_EQ(one.step.response_rad.size(), other.step.response_rad.size());
    for (std::size_t i = 0; i < one.step.response_rad.size(); ++i) {
        // K_D times a rate and K_D v/T round otherwise; so many samples later some 1e-14 of it is left.
        ASSERT_NEAR(one.step.response_rad[i], other.step.response_rad[i], 1e-11);
        ASSERT_NEAR(one.step.current_A[i], other.step.current_A[i], 1e-11 * one.peakCurrent_A);
    }
    EXPECT_NEAR(one.peakCurrent_A / other.peakCurrent_A, 1.0, 1e-12);
    EXPECT_NEAR(one.largestStep_rad / other.largestStep_rad, 1.0, 1e-12);
    EXPECT_NEAR(one.step.metrics.overshoot_percent, other.step.metrics.overshoot_percent, 1e-8);
}

TEST(FilteredLoop, withNothingFilteredHasTheNumbersOfTheBoardsProof) {
    PidGains noIntegral = lively();
    noIntegral.integral = 0.0;
    PidGains zeroFilter = lively();
    zeroFilter.filter_s = 0.0;
    for (const PidGains& gains : {lively(), noIntegral, zeroFilter}) {
        for (const LoopTiming& timing : {NoDelay, OneLate}) {
            const auto board = assessDesign(published(), gains, timing, Limit_A);
            const auto assessment = assessFilteredDesign(published(), of(gains), timing, Limit_A);
            ASSERT_TRUE(board && assessment);
            expectSame(*assessment, *board);
        }
    }
}

// Poles at -p and of (zeta, w), with b such that the reference's zero lies on -p: what is left is the loop of
// second order with its overshoot exp(-pi zeta/sqrt(1 - zeta^2)). Sampled at 0.1 ms it is that to the 1e-4
// by which half a sample of delay (w T/2 = 1e-3) moves its poles and the peak.
TEST(FilteredLoop, theWeightOfTheReferenceChangesTheOvershootAndNotTheMargins) {
    constexpr double Zeta = 0.5, W_rad_s = 20.0, P_1_s = 4.0;
    constexpr LoopTiming Fine{1e-4, 0};
    const PositionPlant plant = published();
    const double k = plant.accelerationGain_rad_s2_A;
    PidGains gains;
    gains.proportional = (W_rad_s * W_rad_s + 2.0 * Zeta * W_rad_s * P_1_s) / k;
    gains.integral = W_rad_s * W_rad_s * P_1_s / k;
    gains.derivative = (P_1_s + 2.0 * Zeta * W_rad_s - plant.dampingRate_1_s) / k;
    FilteredLaw law = of(gains);
    const auto plain = assessFilteredDesign(plant, law, Fine, Limit_A, 1.0);
    law.proportionalWeight = gains.integral / (gains.proportional * P_1_s);
    const auto weighted = assessFilteredDesign(plant, law, Fine, Limit_A, 1.0);
    ASSERT_TRUE(plain && weighted);
    const double overshoot = 100.0 * std::exp(-Pi * Zeta / std::sqrt(1.0 - Zeta * Zeta));
    EXPECT_NEAR(weighted->step.metrics.overshoot_percent, overshoot, 0.2);
    EXPECT_GT(plain->step.metrics.overshoot_percent, overshoot + 2.0);
    EXPECT_EQ(weighted->poleRadius, plain->poleRadius);
    EXPECT_EQ(weighted->margins.phaseMargin_deg, plain->margins.phaseMargin_deg);
    EXPECT_EQ(weighted->margins.gainMargin_ratio, plain->margins.gainMargin_ratio);
    EXPECT_EQ(weighted->noiseGain_A_per_rad, plain->noiseGain_A_per_rad);
    EXPECT_NEAR(weighted->peakCurrent_A / plain->peakCurrent_A, law.proportionalWeight, 1e-2);
}

// The first current of a step of 1 rad is b K_P + c K_D/(T + T_f): with c = 0 the derivative is not in it.
TEST(FilteredLoop, onlyADerivativeOfTheReferenceKicks) {
    FilteredLaw law = of(lively());
    law.proportionalWeight = 0.5;
    law.gains.filter_s = 0.03;
    for (const double c : {0.0, 1.0}) {
        law.derivativeWeight = c;
        const auto step = filteredStep(published(), law, NoDelay, 1.0, 0.5);
        ASSERT_TRUE(step);
        EXPECT_NEAR(step->current_A.front(), 0.5 * 12.0 + c * 0.8 / 0.04, 1e-12);
    }
}

// Second route of the whole loop: sample by sample against the closed transfer function.
TEST(FilteredLoop, theStepAtTheSamplesIsThatOfTheTransferFunction) {
    FilteredLaw measuredOnly = filtered();
    measuredOnly.derivativeWeight = 0.0;
    for (const FilteredLaw& law : {filtered(), measuredOnly}) {
        for (const LoopTiming& timing : {NoDelay, OneLate}) {
            const auto closed = filteredClosedLoop(published(), law, timing);
            const auto step = filteredStep(published(), law, timing, 1.0, 2.0, 1);
            ASSERT_TRUE(closed && step);
            const std::vector<double> expected =
                simulate(*closed, std::vector<double>(step->response_rad.size(), 1.0));
            for (std::size_t k = 0; k < expected.size(); ++k) {
                ASSERT_NEAR(step->response_rad[k], expected[k], 1e-9) << k;
            }
            EXPECT_NEAR(closed->dcGain(), 1.0, 1e-9); // integral action
        }
    }
}

// Second route: the mean of |C/(1 + L)|^2 over the unit circle. The rectangle rule over a period converges
// with the poles' distance from the circle: 2^15 points are exact for a radius of 0.99.
TEST(FilteredLoop, theNoiseGainIsTheIntegralOverFrequency) {
    PidGains plainGains = lively();
    double before = assessFilteredDesign(published(), of(plainGains), OneLate, Limit_A)->noiseGain_A_per_rad;
    FilteredLaw slowed = of(plainGains);
    slowed.gains.filter_s = 0.02;
    for (const FilteredLaw& law : {slowed, filtered()}) {
        const auto assessment = assessFilteredDesign(published(), law, OneLate, Limit_A);
        const auto controller = filteredController(law, 0.01);
        const auto loop = filteredOpenLoop(published(), law, OneLate);
        ASSERT_TRUE(assessment && assessment->isStable);
        constexpr int Points = 1 << 15;
        double sum = 0.0;
        for (int i = 0; i < Points; ++i) {
            const std::complex<double> z = std::polar(1.0, 2.0 * Pi * (i + 0.5) / Points);
            sum += std::norm(controller->at(z) / (1.0 + loop->at(z)));
        }
        EXPECT_NEAR(assessment->noiseGain_A_per_rad / std::sqrt(sum / Points), 1.0, 1e-6);
        EXPECT_LT(assessment->noiseGain_A_per_rad, before); // what the filters are for
    }
}

TEST(FilteredLoop, theFastGainIsThatOfOneSample) {
    FilteredLaw law = of(lively());
    law.gains.filter_s = 0.03;
    const auto assessment = assessFilteredDesign(published(), law, NoDelay, Limit_A);
    ASSERT_TRUE(assessment);
    EXPECT_NEAR(assessment->fastGain_A_per_rad, 12.0 + 0.8 / 0.04, 1e-9);
    EXPECT_GT(assessment->proportionalLimit_A_per_rad, 12.0);
}

// At the limit that the proof tells the loop is on the circle, a per mille beside it within and outside.
TEST(FilteredLoop, theLimitOfTheProportionalGainIsWhereTheLoopBreaks) {
    FilteredLaw law = filtered();
    const auto assessment = assessFilteredDesign(published(), law, OneLate, Limit_A);
    ASSERT_TRUE(assessment);
    law.proportionalWeight = 1.0;
    law.gains.integral = 0.0;
    const auto radius = [&](double factor) {
        law.gains.proportional = factor * assessment->proportionalLimit_A_per_rad;
        return poleRadius(*filteredOpenLoop(published(), law, OneLate));
    };
    EXPECT_LT(radius(0.999), 1.0);
    EXPECT_GT(radius(1.001), 1.0);
}

TEST(FilteredLoop, badInputsAreRefused) {
    EXPECT_FALSE(assessFilteredDesign(published(), filtered(), NoDelay, 0.0));
    EXPECT_FALSE(assessFilteredDesign({1.0, -1.0, 0.0}, filtered(), NoDelay, Limit_A));
    EXPECT_FALSE(filteredStep(published(), filtered(), NoDelay, 0.0, 1.0));
    FilteredLaw law = filtered();
    law.proportionalWeight = 2.0;
    EXPECT_FALSE(assessFilteredDesign(published(), law, NoDelay, Limit_A));
    EXPECT_FALSE(FilteredController::make(law, 0.01));
}

} // namespace
} // namespace halbench::control
