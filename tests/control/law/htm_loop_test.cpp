// Every loop fact of help: htm-theory.md sections 3.7, 5, 6 and 8.4, for the published motor.
#include "control/analysis/loop_functions.h"
#include "control/base/units.h"
#include "control/law/position_loop.h"
#include "control/lti/responses.h"
#include "tests/control/published_motor.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::control {
namespace {

constexpr LoopTiming OneSample{0.01, 1};
constexpr LoopTiming TwoSamples{0.01, 2};

PidGains gains(double kp, double ki, double kd = 0.0) {
    PidGains result;
    result.proportional = kp;
    result.integral = ki;
    result.derivative = kd;
    return result;
}

TransferFunction closed(const TransferFunction& loop) {
    return *feedback(loop, TransferFunction::gain(1.0, loop.timeBase()));
}

Damping dominantPair(const TransferFunction& system) {
    for (const Damping& mode : damping(system)) {
        if (mode.pole.imag() > 0.0) {
            return mode;
        }
    }
    return {};
}

TEST(HtmPlant, sampledCoefficientsAreThoseOfTheTheory) {
    const auto plant = sampledPlant(published(), 0.01);
    EXPECT_NEAR(plant.numerator()[0], 1.2903630e-3, 0.5e-10);
    EXPECT_NEAR(plant.numerator()[1], 1.2807798e-3, 0.5e-10);
    EXPECT_NEAR(plant.denominator()[2], 0.9778846, 0.5e-7);
}

TEST(HtmPlant, withoutDampingIsTheSampledDoubleIntegrator) {
    const auto plant = sampledPlant({0.0, 26.0, 0.0}, 0.01);
    EXPECT_DOUBLE_EQ(plant.numerator()[0], 26.0 * 0.5e-4);
    EXPECT_DOUBLE_EQ(plant.numerator()[1], 26.0 * 0.5e-4);
    EXPECT_EQ(plant.denominator()[2], 1.0);
}

// Tolerances below: one unit of the last digit shown, as the theory states for this table.
TEST(HtmPublishedLoop, continuousFactsAreThoseOfTheTheory) {
    const auto loop = *continuousOpenLoop(published(), gains(10.0, 0.1));
    const Damping pair = dominantPair(closed(loop));
    EXPECT_NEAR(pair.naturalFrequency_rad_s, 16.12, 0.01);
    EXPECT_NEAR(pair.damping_ratio, 0.0690, 0.0001);
    const StabilityMargins margins = smallestMargins(loop);
    EXPECT_NEAR(margins.gainCrossover_rad_s.value(), 16.05, 0.01);
    EXPECT_NEAR(margins.phaseMargin_deg, 7.90, 0.01);
    EXPECT_NEAR(margins.delayMargin_s, 8.6e-3, 0.1e-3);
    EXPECT_NEAR(20.0 * std::log10(peakMagnitude(closed(loop)).magnitude_ratio), 17.2, 0.1);
    EXPECT_NEAR(bandwidth_rad_s(closed(loop)).value() / (2.0 * Pi), 3.974, 0.001);
    const auto atOneHertz = closed(loop).atFrequency(2.0 * Pi);
    EXPECT_NEAR(std::abs(atOneHertz), 1.1768, 0.0001);
    EXPECT_NEAR(radiansToDegrees(std::arg(atOneHertz)), -3.63, 0.01);
}

TEST(HtmPublishedLoop, sampledFactsAreThoseOfTheTheory) {
    const auto loop = *sampledOpenLoop(published(), gains(10.0, 0.1), NoDelay);
    const Damping pair = dominantPair(closed(loop));
    EXPECT_NEAR(pair.naturalFrequency_rad_s, 16.09, 0.01);
    EXPECT_NEAR(pair.damping_ratio, 0.0288, 0.0001);
    const StabilityMargins margins = smallestMargins(loop);
    EXPECT_NEAR(margins.gainCrossover_rad_s.value(), 16.04, 0.01);
    EXPECT_NEAR(margins.phaseMargin_deg, 3.31, 0.01);
    EXPECT_NEAR(margins.delayMargin_s, 3.60e-3, 0.01e-3);
    EXPECT_NEAR(20.0 * std::log10(peakMagnitude(closed(loop)).magnitude_ratio), 24.8, 0.1);
}

TEST(HtmPublishedLoop, printedGainHasAGainMarginOfOnePointSevenThree) {
    const auto loop = *sampledOpenLoop(published(), gains(10.0, 0.0), NoDelay);
    EXPECT_NEAR(smallestMargins(loop).gainMargin_ratio, 1.73, 0.01);
}

TEST(HtmPublishedLoop, slowPoleIsAtMinusTheIntegralRate) {
    for (const auto& loop : {*continuousOpenLoop(published(), gains(10.0, 0.1)),
                             *sampledOpenLoop(published(), gains(10.0, 0.1), NoDelay)}) {
        double slowest = HUGE_VAL;
        for (const Damping& mode : damping(closed(loop))) {
            slowest = std::min(slowest, mode.naturalFrequency_rad_s);
        }
        EXPECT_NEAR(slowest, 0.0100, 0.0001);
    }
}

TEST(HtmPublishedLoop, oneSampleOfDelayMakesItUnstable) {
    EXPECT_NEAR(poleRadius(*sampledOpenLoop(published(), gains(10.0, 0.1), OneSample)), 1.0080, 0.0001);
}

TEST(HtmStabilityLimit, isThatOfTheTheoryForEachDelay) {
    EXPECT_NEAR(proportionalLimit_A_per_rad(published(), NoDelay), 17.27, 0.01);
    EXPECT_NEAR(proportionalLimit_A_per_rad(published(), OneSample), 5.77, 0.01);
    EXPECT_NEAR(proportionalLimit_A_per_rad(published(), TwoSamples), 3.47, 0.01);
}

// Second route: Jury's criterion on z^2 - (1 + E - K b1) z + E + K b2: the product of the poles is 1.
TEST(HtmStabilityLimit, withoutDelayIsThatOfJurysCriterion) {
    const PositionPlant plant = published();
    const double x = plant.dampingRate_1_s * 0.01;
    const double E = std::exp(-x);
    const double b2 =
        plant.accelerationGain_rad_s2_A / std::pow(plant.dampingRate_1_s, 2) * (1.0 - E - x * E);
    EXPECT_NEAR(proportionalLimit_A_per_rad(plant, NoDelay), (1.0 - E) / b2, 1e-6);
}

TEST(HtmStabilityLimit, crossingItFlipsTheStabilityLamp) {
    for (const auto& [timing, limit] : {std::pair{NoDelay, 17.27}, std::pair{OneSample, 5.77}}) {
        EXPECT_LT(poleRadius(*sampledOpenLoop(published(), gains(limit - 0.01, 0.0), timing)), 1.0);
        EXPECT_GT(poleRadius(*sampledOpenLoop(published(), gains(limit + 0.01, 0.0), timing)), 1.0);
    }
}

TEST(HtmStabilityLimit, isWhereTheGainMarginPuts) {
    const auto loop = *sampledOpenLoop(published(), gains(10.0, 0.0), OneSample);
    EXPECT_NEAR(10.0 * smallestMargins(loop).gainMargin_ratio,
                proportionalLimit_A_per_rad(published(), OneSample), 1e-6);
}

TEST(HtmRecommendedLoop, marginsAreThoseOfTheTheory) {
    const auto loop = *sampledOpenLoop(published(), gains(40.0, 60.0, 1.4), NoDelay);
    const StabilityMargins margins = smallestMargins(loop);
    EXPECT_NEAR(margins.gainCrossover_rad_s.value(), 45.7, 0.1);
    EXPECT_NEAR(margins.phaseMargin_deg, 37.9, 0.1);
    EXPECT_NEAR(margins.gainMargin_ratio, 4.2, 0.1);
}

TEST(HtmRecommendedLoop, isStableWithAndWithoutASampleOfDelay) {
    for (const auto& timing : {NoDelay, OneSample}) {
        EXPECT_NEAR(poleRadius(*sampledOpenLoop(published(), gains(40.0, 60.0, 1.4), timing)), 0.984, 0.001);
    }
}

// 6.7: +-8.21 deg at 10 A/rad; the micro-steps need 4.48 A/deg for +-0.32 deg, +-0.64 deg needs 2.24 A/deg.
TEST(HtmFrictionBand, isThatOfTheTheory) {
    PositionLaw law;
    law.gains = gains(10.0, 0.1);
    EXPECT_NEAR(radiansToDegrees(frictionBand_rad(published(), law)), 8.21, 0.01);
    law.gains = gains(2.24, 0.0);
    law.gains.unit = GainUnit::PerDegree;
    EXPECT_NEAR(radiansToDegrees(frictionBand_rad(published(), law)), 0.64, 0.001);
    law.gains.proportional = 4.48;
    EXPECT_NEAR(radiansToDegrees(frictionBand_rad(published(), law)), 0.32, 0.001);
}

// Second route: the rational closed loop as a difference equation. The derivative acts on the angle alone, so
// psi/ref = (K_P + T K_I/(z-1)) z^-1 G / (1 + L).
TEST(LinearStep, agreesWithTheDifferenceEquationAtTheSamples) {
    const PidGains pid = gains(40.0, 60.0, 1.4);
    const auto step = linearStep(published(), pid, OneSample, 1.0, 1.0, 10);
    ASSERT_TRUE(step.has_value());
    const auto plant = sampledPlant(published(), 0.01);
    // Everything over D = z (z-1) z D_G: integrator, derivative, delay, plant.
    const Polynomial reference =
        multiply({40.0, 0.01 * 60.0 - 40.0}, multiply({1.0, 0.0}, plant.numerator()));
    const auto loop = *sampledOpenLoop(published(), pid, OneSample);
    const auto system = *TransferFunction::make(reference, add(loop.denominator(), loop.numerator()),
                                                TimeBase::sampled(0.01));
    const auto expected = simulate(system, std::vector<double>(101, 1.0));
    for (std::size_t k = 0; k < expected.size(); ++k) {
        EXPECT_NEAR(step->response_rad[10 * k], expected[k], 1e-9);
    }
}

TEST(LinearStep, startsWithTheProportionalCurrentAfterTheDelay) {
    const auto step = linearStep(published(), gains(10.0, 0.1), TwoSamples, 0.5, 0.1, 10);
    ASSERT_TRUE(step.has_value());
    EXPECT_EQ(step->current_A[19], 0.0);
    EXPECT_DOUBLE_EQ(step->current_A[20], 5.0);
    EXPECT_EQ(step->response_rad[20], 0.0);
}

TEST(LinearStep, ofThePublishedLoopWithoutFrictionOvershootsAsTheSampledPairSays) {
    const auto step = linearStep(published(), gains(10.0, 0.1), NoDelay, 1.0, 3.0);
    ASSERT_TRUE(step.has_value());
    const double zeta = 0.0288;
    // The held input adds a little over the pure pair; the pair alone gives 91.3 %.
    EXPECT_NEAR(step->metrics.overshoot_percent, 100.0 * std::exp(-Pi * zeta / std::sqrt(1.0 - zeta * zeta)),
                3.0);
}

TEST(PositionLoop, refusesWhatIsNoMotorAndNoTiming) {
    EXPECT_EQ(sampledOpenLoop({1.0, 0.0, 0.0}, gains(1.0, 0.0), NoDelay).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(sampledOpenLoop({std::nan(""), 1.0, 0.0}, gains(1.0, 0.0), NoDelay).error().code,
              ErrorCode::NotFinite);
    EXPECT_EQ(sampledOpenLoop(published(), gains(std::nan(""), 0.0), NoDelay).error().code,
              ErrorCode::NotFinite);
    EXPECT_EQ(sampledOpenLoop(published(), gains(1.0, 0.0), {0.01, -1}).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(linearStep(published(), gains(1.0, 0.0), NoDelay, 0.0, 1.0).error().code,
              ErrorCode::OutOfRange);
    EXPECT_EQ(linearStep(published(), gains(1.0, 0.0), NoDelay, 1.0, -1.0).error().code,
              ErrorCode::OutOfRange);
}

} // namespace
} // namespace halbench::control
