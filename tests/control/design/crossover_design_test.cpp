#include "control/analysis/margins.h"
#include "control/base/random.h"
#include "control/base/units.h"
#include "control/design/crossover_design.h"
#include "control/design/design_methods.h"
#include "tests/control/published_motor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace halbench::control {
namespace {

constexpr double ShapeRate_ratio = 0.0328;

PidGains recommended(const LoopTiming& timing) {
    return designLaw("recommended", published(), timing, {})->gains;
}

double radiusAt(const PidGains& gains, const LoopTiming& timing, double factor = 1.0) {
    PidGains scaled = gains;
    scaled.proportional *= factor;
    scaled.integral *= factor;
    scaled.derivative *= factor;
    return poleRadius(*sampledOpenLoop(published(), scaled, timing));
}

// The second route: the margins that the scan of the finished loop finds.
TEST(CrossoverDesign, theLoopCrossesWhereAndWithTheMarginThatWasAsked) {
    for (const LoopTiming timing : {LoopTiming{0.01, 0}, LoopTiming{0.01, 1}, LoopTiming{0.002, 2}}) {
        const double fastest_rad_s = 0.3 / (timing.period_s * (1.0 + timing.delay_samples));
        for (const double share : {0.1, 0.3, 1.0}) {
            for (const double margin_deg : {45.0, 55.0}) {
                const CrossoverAim aim{share * fastest_rad_s, margin_deg, ShapeRate_ratio};
                const auto design = designCrossover(published(), timing, aim, CrossoverPriority::Margin);
                ASSERT_TRUE(design);
                if (design->limit != CrossoverLimit::None) {
                    continue;
                }
                const auto margins = smallestMargins(*sampledOpenLoop(published(), design->gains, timing));
                // The scan narrows a crossing down to rounding; the loop itself keeps some ten digits.
                ASSERT_TRUE(margins.gainCrossover_rad_s.has_value());
                EXPECT_NEAR(*margins.gainCrossover_rad_s, aim.crossover_rad_s, 1e-6 * aim.crossover_rad_s);
                EXPECT_NEAR(margins.phaseMargin_deg, margin_deg, 1e-5);
            }
        }
    }
}

TEST(CrossoverDesign, theAimOfAnyGainsLeadsBackToThem) {
    for (const char* method : {"recommended", "published", "lqr", "lambda", "lead"}) {
        const PidGains gains = designLaw(method, published(), NoDelay, {})->gains;
        const auto aim = crossoverAimOf(published(), NoDelay, gains);
        ASSERT_TRUE(aim.has_value()) << method;
        const auto design = designCrossover(published(), NoDelay, *aim, CrossoverPriority::Margin);
        ASSERT_TRUE(design) << method;
        if (design->limit != CrossoverLimit::None) {
            EXPECT_EQ(std::string(method), "published"); // 3 degrees of margin are less than it may have
            continue;
        }
        // The aim is read off the crossing of the finished loop, which keeps some ten digits, and two
        // equations are solved for the way back: 1e-6 of K_P in each, 1e-8 in K_D, whose weight at the
        // crossover is larger.
        EXPECT_NEAR(design->gains.proportional, gains.proportional, 1e-6 * gains.proportional) << method;
        EXPECT_NEAR(design->gains.integral, gains.integral, 1e-6 * gains.proportional) << method;
        EXPECT_NEAR(design->gains.derivative, gains.derivative, 1e-8 * gains.proportional) << method;
    }
}

TEST(CrossoverDesign, aLoopThatDoesNotCrossHasNoAim) {
    EXPECT_FALSE(crossoverAimOf(published(), NoDelay, {}).has_value());
}

// Below the corner of the motor PI alone has more margin than is asked: less would take a negative K_D.
TEST(CrossoverDesign, aMarginBelowThatOfPiIsRefusedInFavourOfThatOfPi) {
    const CrossoverAim aim{3.0, 20.0, 0.0};
    const auto design = designCrossover(published(), NoDelay, aim, CrossoverPriority::Crossover);
    ASSERT_TRUE(design);
    EXPECT_EQ(design->limit, CrossoverLimit::Derivative);
    EXPECT_DOUBLE_EQ(design->reached.crossover_rad_s, 3.0);
    // P alone: 90 - atan(w/a) - w T/2 in degrees = 35.8 (half a sample for the hold)
    const double ofP_deg = 90.0 - radiansToDegrees(std::atan(3.0 / published().dampingRate_1_s) + 0.015);
    EXPECT_NEAR(design->reached.phaseMargin_deg, ofP_deg, 0.02);
    EXPECT_NEAR(design->gains.derivative / design->gains.proportional, 0.0, 1e-4);
}

TEST(CrossoverDesign, aCrossoverThatIsTooFastStopsWhereTheMarginCanStillBeHad) {
    for (const int delay_samples : {0, 1, 2}) {
        const LoopTiming timing{0.01, delay_samples};
        CrossoverAim aim = *crossoverAimOf(published(), timing, recommended(timing));
        const double margin_deg = aim.phaseMargin_deg;
        aim.crossover_rad_s = 250.0;
        const auto design = designCrossover(published(), timing, aim, CrossoverPriority::Margin);
        ASSERT_TRUE(design);
        EXPECT_NE(design->limit, CrossoverLimit::None);
        EXPECT_LT(design->reached.crossover_rad_s, 250.0);
        EXPECT_GE(design->reached.phaseMargin_deg, margin_deg - 1e-9);
        EXPECT_LT(radiusAt(design->gains, timing, crossover::LeastGainMargin_ratio), 1.0);
        // It is the edge: 2 % further nothing is possible with this margin.
        aim.crossover_rad_s = 1.02 * design->reached.crossover_rad_s;
        const auto beyond = designCrossover(published(), timing, aim, CrossoverPriority::Margin);
        EXPECT_NE(beyond->limit, CrossoverLimit::None);
        EXPECT_LT(beyond->reached.crossover_rad_s, aim.crossover_rad_s);
    }
}

TEST(CrossoverDesign, everyAimEndsInFiniteGainsOfAStableLoopOrARefusal) {
    Random random(7);
    const std::vector<PositionPlant> motors = {
        published(), {0.0, 26.0, 0.0}, {50.0, 900.0, 0.1}, {1e-3, 1e-2, 0.0}};
    for (int i = 0; i < 400; ++i) {
        const PositionPlant& plant = motors[static_cast<std::size_t>(i) % motors.size()];
        const LoopTiming timing{i % 3 == 0 ? 0.001 : 0.01, i % 4 % 3};
        const CrossoverAim aim{std::exp(3.0 * random.gaussian() + 3.0), 60.0 * random.gaussian() + 40.0,
                               0.05 * random.gaussian()};
        const auto priority = i % 2 == 0 ? CrossoverPriority::Margin : CrossoverPriority::Crossover;
        const auto design = designCrossover(plant, timing, aim, priority);
        if (!design) {
            EXPECT_EQ(design.error().code, ErrorCode::Refused);
            continue;
        }
        for (const double gain :
             {design->gains.proportional, design->gains.integral, design->gains.derivative}) {
            ASSERT_TRUE(std::isfinite(gain));
            ASSERT_GE(gain, 0.0);
        }
        ASSERT_GT(design->gains.proportional, 0.0);
        ASSERT_LT(poleRadius(*sampledOpenLoop(plant, design->gains, timing)), 1.0) << i;
    }
}

TEST(CrossoverDesign, noNumberThatIsNoneIsTaken) {
    for (const double none :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        for (const CrossoverAim& aim :
             {CrossoverAim{none, 40.0, 0.0}, {40.0, none, 0.0}, {40.0, 40.0, none}, {-none, 40.0, 0.0}}) {
            const auto design = designCrossover(published(), NoDelay, aim, CrossoverPriority::Margin);
            ASSERT_FALSE(design);
            EXPECT_EQ(design.error().code, ErrorCode::NotFinite);
        }
    }
}

// A hand that moves by one pixel must not make the gains jump, also along the edge of what is possible.
TEST(CrossoverDesign, smallMovesOfTheAimAreSmallMovesOfTheGains) {
    CrossoverAim aim = *crossoverAimOf(published(), NoDelay, recommended(NoDelay));
    std::optional<double> before;
    for (double crossover_rad_s = 10.0; crossover_rad_s < 250.0; crossover_rad_s *= 1.01) {
        aim.crossover_rad_s = crossover_rad_s;
        const auto design = designCrossover(published(), NoDelay, aim, CrossoverPriority::Margin);
        ASSERT_TRUE(design);
        if (before) {
            // K_P goes with the square of the crossover: 2 % a step of 1 %, five times that at an edge.
            EXPECT_NEAR(std::log(design->gains.proportional / *before), 0.0, 0.1) << crossover_rad_s;
        }
        before = design->gains.proportional;
    }
}

// 17.27 A/rad is the limit of the published motor without delay (htm-theory.md 3.7).
TEST(CrossoverDesign, aFactorStopsAtTheLimitOfStability) {
    PidGains gains;
    gains.proportional = 10.0;
    EXPECT_NEAR(10.0 * stableFactor(published(), NoDelay, gains, 5.0), 17.27, 0.01);
    EXPECT_DOUBLE_EQ(stableFactor(published(), NoDelay, gains, 1.5), 1.5);
    gains.proportional = 40.0; // beyond it already: whoever holds it finds the way back
    EXPECT_DOUBLE_EQ(stableFactor(published(), NoDelay, gains, 0.3), 0.3);
    EXPECT_DOUBLE_EQ(stableFactor(published(), NoDelay, gains, 1.2), 1.2);
}

// What stands around the gains is in the loop that crosses there: read off that loop.
TEST(CrossoverDesign, throughFiltersTheLoopHasTheCrossoverAndTheMarginToo) {
    FilteredLaw around;
    around.gains.filter_s = 0.003;
    around.filters = {NotchFilter{200.0, 0.3, 0.4}, LowPassFilter{280.0, 1}};
    const CrossoverAim aim{35.0, 35.0, 0.04};
    for (const int delay : {0, 1}) {
        const LoopTiming timing{0.01, delay};
        const auto design = designCrossover(published(), timing, {35.0, delay == 0 ? 35.0 : 20.0, 0.02},
                                            CrossoverPriority::Margin, around);
        ASSERT_TRUE(design);
        FilteredLaw law = around;
        law.gains = design->gains;
        law.gains.filter_s = around.gains.filter_s;
        const auto loop = filteredOpenLoop(published(), law, timing);
        ASSERT_TRUE(loop);
        EXPECT_LT(poleRadius(*loop), 1.0);
        const StabilityMargins margins = smallestMargins(*loop);
        EXPECT_NEAR(*margins.gainCrossover_rad_s, design->reached.crossover_rad_s, 1e-6);
        EXPECT_NEAR(margins.phaseMargin_deg, design->reached.phaseMargin_deg, 1e-6);
        const auto back = crossoverAimOf(published(), timing, design->gains, around);
        ASSERT_TRUE(back);
        EXPECT_NEAR(back->crossover_rad_s, design->reached.crossover_rad_s, 1e-6);
        // The factor that it bears ends where the loop does.
        const double factor = stableFactor(published(), timing, design->gains, 50.0, around);
        law.gains.proportional *= 1.001 * factor;
        law.gains.integral *= 1.001 * factor;
        law.gains.derivative *= 1.001 * factor;
        EXPECT_GT(poleRadius(*filteredOpenLoop(published(), law, timing)), 1.0);
    }
    around.filters = {LowPassFilter{1e6, 1}};
    EXPECT_FALSE(designCrossover(published(), NoDelay, aim, CrossoverPriority::Margin, around));
}

} // namespace
} // namespace halbench::control
