#include "control/analysis/loop_functions.h"
#include "control/base/units.h"
#include "control/design/design_methods.h"
#include "tests/control/published_motor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace halbench::control {
namespace {

PositionPlant other() {
    return {1.1, 75.0, 0.6};
}

StabilityMargins marginsOf(const PositionPlant& plant, const PositionLaw& law, const LoopTiming& timing) {
    return smallestMargins(*sampledOpenLoop(plant, law.gains, timing));
}

DesignTargets phaseMargin(double margin_deg) {
    DesignTargets targets;
    targets.phaseMargin_deg = margin_deg;
    return targets;
}

DesignTargets bandwidth(double bandwidth_Hz) {
    DesignTargets targets;
    targets.bandwidth_Hz = bandwidth_Hz;
    return targets;
}

// help: htm-theory.md 6.4, 6.5
TEST(Design, theSourcesOwnTargetsGiveItsTrueGains) {
    const auto law = designLaw("designed", published(), NoDelay, {});
    ASSERT_TRUE(law.has_value());
    EXPECT_NEAR(law->gains.proportional, 8.684, 0.5e-3); // half of the last printed digit
    EXPECT_NEAR(law->gains.integral, 3.776, 0.5e-3);
}

TEST(Design, polePlacementPutsThePairWhereAsked) {
    const auto law = designLaw("pole-placement", other(), NoDelay, {0.04, 12.0, {}, {}});
    ASSERT_TRUE(law.has_value());
    const auto poles = closedLoopPoles(*continuousOpenLoop(other(), law->gains));
    const std::complex<double> wanted(-0.04 * 12.0, 12.0 * std::sqrt(1.0 - 0.04 * 0.04));
    double nearest = HUGE_VAL;
    for (const auto& pole : poles) {
        nearest = std::min(nearest, std::abs(pole - wanted));
    }
    EXPECT_LT(nearest, 1e-9);
}

// zeta <= c/(2 J omega): 0.0745 at 15 rad/s (help: htm-theory.md 3.6)
TEST(Design, polePlacementRefusesMoreDampingThanTheMotorHas) {
    EXPECT_TRUE(designLaw("pole-placement", published(), NoDelay, {0.0745, 15.0, {}, {}}).has_value());
    const auto refused = designLaw("pole-placement", published(), NoDelay, {0.0746, 15.0, {}, {}});
    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(refused.error().code, ErrorCode::OutOfRange);
    EXPECT_NE(refused.error().message.find("0.0745"), std::string::npos);
}

TEST(Design, recommendedIsTheProductsPresetOnThePublishedMotor) {
    const auto law = designLaw("recommended", published(), NoDelay, {});
    ASSERT_TRUE(law.has_value());
    EXPECT_NEAR(law->gains.proportional, 40.0, 1e-9);
    EXPECT_NEAR(law->gains.integral, 60.0, 1e-9);
    EXPECT_NEAR(law->gains.derivative, 1.4, 1e-9);
    EXPECT_NEAR(law->inertia_A_s2_rad, 5.5e-4 / 1.43e-2, 1e-12);
    EXPECT_NEAR(law->viscous_A_s_rad, 1.23e-3 / 1.43e-2, 1e-12);
    EXPECT_NEAR(law->coulomb_A, 0.9 * 2.05e-2 / 1.43e-2, 1e-12);
}

TEST(Design, recommendedHasTheSameMarginsOnAnotherMotor) {
    const StabilityMargins reference =
        marginsOf(published(), *designLaw("recommended", published(), NoDelay, {}), NoDelay);
    const StabilityMargins scaled =
        marginsOf(other(), *designLaw("recommended", other(), NoDelay, {}), NoDelay);
    // The continuous polynomial is the same, but damping by the motor is replaced by damping through the held
    // loop: 1.14 of 38.6 1/s, 3 % of the margins.
    EXPECT_NEAR(scaled.phaseMargin_deg, reference.phaseMargin_deg, 1.0);
    EXPECT_NEAR(scaled.gainMargin_ratio, reference.gainMargin_ratio, 0.03 * 4.2 + 0.02);
}

TEST(Design, recommendedPaysForAComputingDelayWithSpeed) {
    for (const int delay : {1, 2}) {
        const LoopTiming timing{0.01, delay};
        const auto law = designLaw("recommended", published(), timing, {});
        ASSERT_TRUE(law.has_value());
        EXPECT_LT(law->gains.proportional, 40.0);
        EXPECT_LT(poleRadius(*sampledOpenLoop(published(), law->gains, timing)), 1.0);
        EXPECT_GE(marginsOf(published(), *law, timing).phaseMargin_deg, 35.0);
    }
}

TEST(Design, bandwidthIsMetByTheSampledLoop) {
    for (const double wanted_Hz : {1.0, 4.0, 9.0}) {
        const auto law = designLaw("bandwidth", published(), NoDelay, bandwidth(wanted_Hz));
        ASSERT_TRUE(law.has_value()) << wanted_Hz;
        const auto loop = *sampledOpenLoop(published(), law->gains, NoDelay);
        const auto closed = *feedback(loop, TransferFunction::gain(1.0, loop.timeBase()));
        EXPECT_NEAR(bandwidth_rad_s(closed).value() / (2.0 * Pi), wanted_Hz, 1e-6 * wanted_Hz);
        EXPECT_LT(poleRadius(loop), 1.0);
    }
}

// 25 deg are left where the method stops (help: tuning.md), at 22.4 Hz on the published motor.
TEST(Design, bandwidthEndsWhereThePhaseMarginDoes) {
    const auto last = designLaw("bandwidth", published(), NoDelay, bandwidth(22.0));
    ASSERT_TRUE(last.has_value());
    EXPECT_NEAR(marginsOf(published(), *last, NoDelay).phaseMargin_deg, 25.0, 1.0); // 0.4 Hz before the end
    EXPECT_EQ(designLaw("bandwidth", published(), NoDelay, bandwidth(23.0)).error().code,
              ErrorCode::OutOfRange);
}

TEST(Design, bandwidthBeyondReachIsRefusedWithWhatIsPossible) {
    const auto refused = designLaw("bandwidth", published(), NoDelay, bandwidth(45.0));
    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(refused.error().code, ErrorCode::OutOfRange);
    EXPECT_NE(refused.error().hint.find("Hz"), std::string::npos);
}

TEST(Design, phaseMarginIsMetByTheSampledLoopWithItsDelay) {
    for (const int delay : {0, 1, 2}) {
        for (const double wanted_deg : {30.0, 45.0, 60.0}) {
            const LoopTiming timing{0.01, delay};
            const auto law = designLaw("phase-margin", published(), timing, phaseMargin(wanted_deg));
            ASSERT_TRUE(law.has_value()) << delay << " " << wanted_deg << " " << law.error().message;
            const StabilityMargins margins = marginsOf(published(), *law, timing);
            EXPECT_NEAR(margins.phaseMargin_deg, wanted_deg, 0.01); // what the method bisects to
            EXPECT_GE(margins.gainMargin_ratio, 2.0);
            EXPECT_LT(poleRadius(*sampledOpenLoop(published(), law->gains, timing)), 1.0);
        }
    }
}

// A margin bought with derivative action alone would leave a friction band of hundreds of degrees.
TEST(Design, phaseMarginIsNotBoughtWithStiffness) {
    for (const int delay : {0, 1, 2}) {
        const LoopTiming timing{0.01, delay};
        const auto law = designLaw("phase-margin", published(), timing, phaseMargin(60.0));
        ASSERT_TRUE(law.has_value());
        const double crossover = marginsOf(published(), *law, timing).gainCrossover_rad_s.value();
        EXPECT_GT(law->gains.proportional * 26.0, 0.1 * crossover * crossover);
    }
}

TEST(Design, aGivenCrossoverIsKeptOrRefused) {
    DesignTargets targets = phaseMargin(45.0);
    targets.omega_rad_s = 30.0;
    const auto law = designLaw("phase-margin", published(), NoDelay, targets);
    ASSERT_TRUE(law.has_value());
    EXPECT_NEAR(marginsOf(published(), *law, NoDelay).gainCrossover_rad_s.value(), 30.0, 1e-6); // ten digits
    targets.omega_rad_s = 200.0;
    EXPECT_EQ(designLaw("phase-margin", published(), NoDelay, targets).error().code, ErrorCode::OutOfRange);
}

TEST(Design, presetsAreTheNumbersOfTheTheory) {
    const auto published_ = designLaw("published", published(), NoDelay, {});
    EXPECT_EQ(published_->gains.proportional, 10.0);
    EXPECT_EQ(published_->gains.integral, 0.1);
    EXPECT_EQ(published_->coulomb_A, 0.0);
    EXPECT_NEAR(designLaw("micro-step", published(), NoDelay, {})->gains.proportional, 5.0 * 180.0 / Pi,
                1e-9);
    EXPECT_NEAR(designLaw("micro-step", published(), NoDelay, {})->gains.integral, 0.05 * 180.0 / Pi, 1e-9);
    EXPECT_NEAR(designLaw("published-degrees", published(), NoDelay, {})->gains.proportional, 572.958,
                1e-3); // last digit
}

TEST(Design, refusesUnknownMethodsForeignTargetsAndNonsense) {
    const auto unknown = designLaw("magic", published(), NoDelay, {});
    EXPECT_EQ(unknown.error().code, ErrorCode::UnknownName);
    EXPECT_NE(unknown.error().hint.find("pole-placement"), std::string::npos);
    EXPECT_EQ(designLaw("recommended", published(), NoDelay, bandwidth(3.0)).error().code, ErrorCode::Usage);
    EXPECT_EQ(designLaw("bandwidth", published(), NoDelay, {}).error().code, ErrorCode::Usage);
    EXPECT_EQ(designLaw("bandwidth", published(), NoDelay, bandwidth(std::nan(""))).error().code,
              ErrorCode::NotFinite);
    EXPECT_EQ(designLaw("bandwidth", published(), NoDelay, bandwidth(-1.0)).error().code,
              ErrorCode::OutOfRange);
    EXPECT_EQ(designLaw("phase-margin", published(), NoDelay, phaseMargin(200.0)).error().code,
              ErrorCode::OutOfRange);
    EXPECT_EQ(designLaw("recommended", {-1.0, 1.0, 0.0}, NoDelay, {}).error().code, ErrorCode::OutOfRange);
}

} // namespace
} // namespace halbench::control
