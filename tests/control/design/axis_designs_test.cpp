#include "control/analysis/margins.h"
#include "control/assess/filtered_loop.h"
#include "control/base/units.h"
#include "control/design/axis_designs.h"
#include "control/law/filtered_delta.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::control {
namespace {

// The six-coil positioner along x: 0.64 kg that moves freely, 1 kHz, one sample of delay
// (resources/help/planar-theory.md sections 8 and 9).
constexpr double Mass_kg = 0.64;
const PositionPlant Platen{0.0, 1.0 / Mass_kg, 0.0};
const LoopTiming Board{1e-3, 1};

StabilityMargins marginsOf(const PositionPlant& plant, const FilteredLaw& law, const LoopTiming& timing) {
    return smallestMargins(*deltaOpenLoop(plant, law, timing));
}

TEST(AxisDesigns, recommendedGainsOfThePlatenAreThePublishedDesign) {
    const auto law = designAxisLaw("recommended", Platen, Board, {});
    ASSERT_TRUE(law) << law.error().message;
    EXPECT_NEAR(law->gains.proportional, 660.48, 0.01); // section 9, all digits printed
    EXPECT_NEAR(law->gains.integral, 1267.2, 0.1);
    EXPECT_NEAR(law->gains.derivative, 39.808, 0.001);
    EXPECT_EQ(law->proportionalWeight, 0.745);
    EXPECT_EQ(law->derivativeWeight, 0.0);
    // A filter of 2 ms that decays by exp(-1/2) in a sample, as a backward difference has it.
    EXPECT_NEAR(*law->gains.filter_s / (*law->gains.filter_s + 1e-3), std::exp(-0.5), 1e-12);
    const StabilityMargins margins = marginsOf(Platen, *law, Board);
    EXPECT_NEAR(*margins.gainCrossover_rad_s / (2.0 * Pi), 10.38, 0.21); // 2 %, section 11
    EXPECT_NEAR(margins.phaseMargin_deg, 62.8, 1.0);                     // 1 degree, section 11
}

TEST(AxisDesigns, rotationAtTwiceTheFrequencyIsThePublishedDesign) {
    const PositionPlant rotation{0.0, 1.0 / 1e-3, 0.0};
    const auto law = designAxisLaw("recommended", rotation, Board, {}, 60.0);
    ASSERT_TRUE(law);
    EXPECT_NEAR(law->gains.proportional, 3.864, 1e-6);
    EXPECT_NEAR(law->gains.integral, 7.92, 1e-6);
    EXPECT_NEAR(law->gains.derivative, 0.1222, 1e-7);
    const StabilityMargins margins = marginsOf(rotation, *law, Board);
    EXPECT_NEAR(*margins.gainCrossover_rad_s / (2.0 * Pi), 20.5, 0.41);
    EXPECT_NEAR(margins.phaseMargin_deg, 51.0, 1.0);
}

TEST(AxisDesigns, stepOfTheRecommendedLoopHasNoOvershoot) {
    const auto law = *designAxisLaw("recommended", Platen, Board, {});
    const auto step = filteredStep(Platen, law, Board, 1.0, 4.0);
    ASSERT_TRUE(step);
    EXPECT_NEAR(*step->metrics.riseTime_s, 0.245, 0.02); // tolerances of section 11
    EXPECT_NEAR(*step->metrics.settlingTime_s, 0.968, 0.05);
    EXPECT_LT(step->metrics.overshoot_percent, 0.5);
    FilteredLaw unweighted = law;
    unweighted.proportionalWeight = 1.0;
    EXPECT_NEAR(filteredStep(Platen, unweighted, Board, 1.0, 4.0)->metrics.overshoot_percent, 8.9, 0.5);
}

TEST(AxisDesigns, anyMassHasTheSameLoop) {
    const LoopTiming slower{5e-3, 2};
    for (const double mass_kg : {0.02, 3.0}) {
        const PositionPlant plant{0.0, 1.0 / mass_kg, 0.0};
        const auto law = designAxisLaw("recommended", plant, slower, {});
        ASSERT_TRUE(law);
        // k K_P depends on the timing alone.
        EXPECT_NEAR(law->gains.proportional / mass_kg,
                    designAxisLaw("recommended", Platen, slower, {})->gains.proportional / Mass_kg,
                    1e-9 * law->gains.proportional / mass_kg);
        EXPECT_GT(marginsOf(plant, *law, slower).phaseMargin_deg, 60.0);
    }
}

TEST(AxisDesigns, aLongDelayLowersTheAskedFrequency) {
    // Three delays of 1 ms more at w = 60 cost 360 deg * 20.5 Hz * 1 ms = 7.4 deg each: below 45 of 51.
    const LoopTiming late{1e-3, 2};
    const PositionPlant rotation{0.0, 1e3, 0.0};
    const auto law = designAxisLaw("recommended", rotation, late, {}, 60.0);
    ASSERT_TRUE(law);
    EXPECT_LT(law->gains.proportional, 3.864);
    EXPECT_NEAR(marginsOf(rotation, *law, late).phaseMargin_deg, 45.0, 0.01);
}

TEST(AxisDesigns, polesOfASlowLoopAreThoseAskedFor) {
    // At w T = 0.005 sampling moves the poles by some percent of themselves only.
    DesignTargets targets;
    targets.omega_rad_s = 5.0;
    targets.zeta = 0.7;
    const PositionPlant damped{1.5, 2.0, 0.0};
    auto law = designAxisLaw("pole-placement", damped, Board, targets);
    ASSERT_TRUE(law) << law.error().message;
    const auto poles = filteredPoles(damped, *law, Board);
    ASSERT_TRUE(poles);
    bool isFound = false;
    for (const std::complex<double>& pole : *poles) {
        const std::complex<double> s = std::log(pole) / Board.period_s;
        isFound = isFound || std::abs(s - std::complex<double>(-3.5, 5.0 * std::sqrt(1.0 - 0.49))) < 0.15;
    }
    EXPECT_TRUE(isFound);
}

TEST(AxisDesigns, askedBandwidthAndMarginAreMet) {
    DesignTargets targets;
    targets.bandwidth_Hz = 15.0;
    const auto fast = designAxisLaw("bandwidth", Platen, Board, targets);
    ASSERT_TRUE(fast) << fast.error().message;
    // |L/(1 + L)| is 3 dB down at 15 Hz.
    const std::complex<double> loop = deltaOpenLoop(Platen, *fast, Board)->atFrequency(2.0 * Pi * 15.0);
    EXPECT_NEAR(20.0 * std::log10(std::abs(loop / (1.0 + loop))), -3.01, 0.02);

    DesignTargets margin;
    margin.phaseMargin_deg = 50.0;
    const auto law = designAxisLaw("phase-margin", Platen, Board, margin);
    ASSERT_TRUE(law) << law.error().message;
    EXPECT_NEAR(marginsOf(Platen, *law, Board).phaseMargin_deg, 50.0, 0.01);
}

TEST(AxisDesigns, everyMethodMakesAStableLoopOfAFreeMass) {
    for (const DesignMethod& method : axisDesignMethods()) {
        DesignTargets targets;
        if (method.name == "bandwidth") {
            targets.bandwidth_Hz = 12.0;
        } else if (method.name == "phase-margin") {
            targets.phaseMargin_deg = 55.0;
        }
        const auto law = designAxisLaw(method.name, Platen, Board, targets);
        ASSERT_TRUE(law) << method.name << ": " << law.error().message;
        EXPECT_LT(*filteredPoleRadius(Platen, *law, Board), 1.0) << method.name;
    }
}

TEST(AxisDesigns, refusesWhatCannotBe) {
    EXPECT_EQ(designAxisLaw("simc", Platen, Board, {}).error().code, ErrorCode::UnknownName);
    EXPECT_EQ(designAxisLaw("bandwidth", Platen, Board, {}).error().code, ErrorCode::Usage);
    DesignTargets targets;
    targets.bandwidth_Hz = 400.0;
    EXPECT_EQ(designAxisLaw("bandwidth", Platen, Board, targets).error().code, ErrorCode::OutOfRange);
    targets = {};
    targets.phaseMargin_deg = 85.0;
    EXPECT_EQ(designAxisLaw("phase-margin", Platen, Board, targets).error().code, ErrorCode::OutOfRange);
    targets = {};
    targets.zeta = 0.5;
    EXPECT_EQ(designAxisLaw("recommended", Platen, Board, targets).error().code, ErrorCode::Usage);
    targets.omega_rad_s = 1.0; // of an axis that damps with 50/s
    EXPECT_EQ(designAxisLaw("pole-placement", {50.0, 1.0, 0.0}, Board, targets).error().code,
              ErrorCode::OutOfRange);
}

} // namespace
} // namespace halbench::control
