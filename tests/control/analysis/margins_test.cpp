#include "control/analysis/loop_functions.h"
#include "control/analysis/margins.h"
#include "control/base/units.h"
#include "control/lti/discretize.h"
#include "tests/control/random_systems.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

TransferFunction continuous(Polynomial numerator, Polynomial denominator) {
    return *TransferFunction::make(std::move(numerator), std::move(denominator), TimeBase::continuous());
}

// K/(s (s+1)(s+2)): phase -180 deg at sqrt(2), where |L| = K/6.
TEST(Margins, gainMarginOfAThirdOrderLoopIsSixOverTheGain) {
    const StabilityMargins margins = smallestMargins(continuous({2.0}, {1.0, 3.0, 2.0, 0.0}));
    EXPECT_NEAR(margins.gainMargin_ratio, 3.0, 1e-12);
    ASSERT_TRUE(margins.phaseCrossover_rad_s.has_value());
    EXPECT_NEAR(*margins.phaseCrossover_rad_s, std::sqrt(2.0), 1e-12);
}

// w_c of K/(s (s + a)) from w^2 (w^2 + a^2) = K^2, phase margin 90 deg - atan(w_c/a).
TEST(Margins, phaseAndDelayMarginOfASecondOrderLoopAreTheClosedForms) {
    const double a = 2.0;
    const double K = 30.0;
    const double w = std::sqrt(0.5 * (-a * a + std::sqrt(a * a * a * a + 4.0 * K * K)));
    const StabilityMargins margins = smallestMargins(continuous({K}, {1.0, a, 0.0}));
    ASSERT_TRUE(margins.gainCrossover_rad_s.has_value());
    EXPECT_NEAR(*margins.gainCrossover_rad_s, w, 1e-12 * w);
    EXPECT_NEAR(margins.phaseMargin_deg, 90.0 - radiansToDegrees(std::atan(w / a)), 1e-10);
    EXPECT_NEAR(margins.delayMargin_s, (Pi / 2.0 - std::atan(w / a)) / w, 1e-13);
    EXPECT_TRUE(std::isinf(margins.gainMargin_ratio));
    EXPECT_FALSE(margins.phaseCrossover_rad_s.has_value());
}

// Beyond the limit the phase margin is negative, and only a further turn of delay brings the loop back onto
// -1.
TEST(Margins, delayMarginOfAnUnstableLoopIsTheWayRound) {
    const StabilityMargins margins = smallestMargins(continuous({20.0}, {1.0, 3.0, 2.0, 0.0}));
    ASSERT_LT(margins.phaseMargin_deg, 0.0);
    EXPECT_LT(margins.gainMargin_ratio, 1.0);
    EXPECT_NEAR(margins.delayMargin_s,
                degreesToRadians(360.0 + margins.phaseMargin_deg) / margins.gainCrossover_rad_s.value(),
                1e-12);
}

TEST(Margins, aLoopWithoutCrossingsHasInfiniteMarginsAndNoFrequencies) {
    const StabilityMargins margins = smallestMargins(continuous({0.5}, {1.0, 1.0}));
    EXPECT_TRUE(std::isinf(margins.gainMargin_ratio));
    EXPECT_TRUE(std::isinf(margins.phaseMargin_deg));
    EXPECT_TRUE(std::isinf(margins.delayMargin_s));
    EXPECT_FALSE(margins.gainCrossover_rad_s.has_value());
    EXPECT_DOUBLE_EQ(margins.modulusMargin, 1.0); // far above the pole L vanishes
}

// Conditionally stable: K (s+1)^2/s^3 crosses -180 deg once, at w = 1, where |L| = 2 K.
TEST(Margins, aConditionallyStableLoopHasAGainMarginBelowOne) {
    const double K = 5.0;
    const auto crossings = allCrossings(continuous({K, 2.0 * K, K}, {1.0, 0.0, 0.0, 0.0}));
    ASSERT_EQ(crossings.size(), 2u);
    EXPECT_EQ(crossings[0].kind, Crossing::Kind::Phase);
    EXPECT_NEAR(crossings[0].frequency_rad_s, 1.0, 1e-12);
    EXPECT_NEAR(crossings[0].gainMargin_ratio, 1.0 / (2.0 * K), 1e-12);
    EXPECT_EQ(crossings[1].kind, Crossing::Kind::Gain);
    EXPECT_GT(crossings[1].phaseMargin_deg, 0.0);
}

// A resonance of damping 1e-4 lifts the loop above 1 in a band far narrower than any plain grid.
TEST(Margins, findsBothCrossingsAroundANarrowResonance) {
    const double w0 = 50.0;
    const double zeta = 1e-4;
    const auto loop = continuous({0.01 * w0 * w0}, {1.0, 2.0 * zeta * w0, w0 * w0});
    const auto crossings = allCrossings(loop);
    ASSERT_EQ(crossings.size(), 2u);
    // |1 - x^2| = 0.01 with x = w/w0, damping negligible to second order
    EXPECT_NEAR(crossings[0].frequency_rad_s, w0 * std::sqrt(0.99), 1e-3);
    EXPECT_NEAR(crossings[1].frequency_rad_s, w0 * std::sqrt(1.01), 1e-3);
}

TEST(Margins, findsACrossingFarOutsideTheRangeOfThePoles) {
    const auto fast = smallestMargins(continuous({1e6}, {1.0, 1.0}));
    EXPECT_NEAR(fast.gainCrossover_rad_s.value(), std::sqrt(1e12 - 1.0), 1e-6);
    const auto slow = smallestMargins(continuous({1e-5}, {1.0, 1.0, 0.0}));
    EXPECT_NEAR(slow.gainCrossover_rad_s.value(), 1e-5, 1e-14);
}

TEST(Margins, theMarginFoundBringsTheLoopToTheLimitOfStability) {
    const auto plant = continuous({8.0}, {1.0, 6.0, 11.0, 6.0});
    const auto sampled = *discretize(plant, 0.2, Hold::Zoh{});
    const double margin = smallestMargins(sampled).gainMargin_ratio;
    const auto closedWith = [&](double factor) {
        const auto loop = *series(sampled, TransferFunction::gain(factor, sampled.timeBase()));
        return isStable(*feedback(loop, TransferFunction::gain(1.0, sampled.timeBase())));
    };
    EXPECT_TRUE(closedWith(margin * (1.0 - 1e-9)));
    EXPECT_FALSE(closedWith(margin * (1.0 + 1e-9)));
}

// A sampled lag K/(z - 0.5) reaches -1 at Nyquist with |L| = K/1.5.
TEST(Margins, aSampledLoopMayCrossAtTheNyquistFrequencyItself) {
    const auto loop = *TransferFunction::make({0.6}, {1.0, -0.5}, TimeBase::sampled(0.1));
    const StabilityMargins margins = smallestMargins(loop);
    EXPECT_NEAR(margins.gainMargin_ratio, 2.5, 1e-12);
    EXPECT_NEAR(margins.phaseCrossover_rad_s.value(), Pi / 0.1, 1e-9);
}

// A rotor without damping, held over a sample: (z + 1)/(z - 1)^2, which is exactly 0 at Nyquist and has no
// margin there. Halved steps of its position make the zero's rounding visible.
TEST(Margins, aLoopThatEndsInAZeroAtNyquistHasNoMarginThere) {
    for (const double gain : {0.013, 0.1, 1.0 / 3.0, 0.7}) {
        const Polynomial held = {gain, gain};
        for (const double period_s : {0.0005, 0.001, 0.01}) {
            const Polynomial derivative = {1.0 + 0.3 / period_s, -0.3 / period_s};
            const auto plain = *TransferFunction::make(held, {1.0, -2.0, 1.0}, TimeBase::sampled(period_s));
            const auto damped = *TransferFunction::make(multiply(held, derivative), {1.0, -2.0, 1.0, 0.0},
                                                        TimeBase::sampled(period_s));
            for (const TransferFunction& loop : {plain, damped}) {
                for (const Crossing& crossing : allCrossings(loop)) {
                    EXPECT_LT(crossing.gainMargin_ratio, 1e6) << gain << ' ' << period_s;
                }
            }
            EXPECT_TRUE(std::isinf(smallestMargins(plain).gainMargin_ratio)) << gain;
        }
    }
}

// A large margin at Nyquist that is one: |L| = 1e-9/1.5.
TEST(Margins, aSmallLoopMayCrossAtTheNyquistFrequencyToo) {
    const auto loop = *TransferFunction::make({1e-9}, {1.0, -0.5}, TimeBase::sampled(0.1));
    EXPECT_NEAR(smallestMargins(loop).gainMargin_ratio, 1.5e9, 1e-3);
}

TEST(Margins, modulusMarginIsTheInverseOfTheSensitivityPeak) {
    const auto plant = continuous({4.0}, {1.0, 1.0, 0.0});
    const auto controller = continuous({0.2, 1.0}, {0.01, 1.0});
    const auto loop = *series(plant, controller);
    const auto functions = loopFunctions(plant, controller);
    ASSERT_TRUE(functions.has_value());
    EXPECT_NEAR(smallestMargins(loop).modulusMargin, 1.0 / peakMagnitude(functions->S).magnitude_ratio, 1e-9);
}

// K exp(-s t)/s crosses -180 deg first where w t = pi/2, with |L| = K/w; then every turn.
TEST(Margins, ofAnIntegratorBehindADeadTimeAreTheClosedForms) {
    const double K = 3.0;
    const double t = 0.1;
    const auto loop = *DeadTimeSystem::make(continuous({K}, {1.0, 0.0}), t);
    const StabilityMargins margins = smallestMargins(loop);
    EXPECT_NEAR(margins.gainCrossover_rad_s.value(), K, 1e-12 * K);
    EXPECT_NEAR(margins.phaseMargin_deg, 90.0 - radiansToDegrees(K * t), 1e-10);
    EXPECT_NEAR(margins.gainMargin_ratio, 0.5 * Pi / (K * t), 1e-10);
    EXPECT_NEAR(margins.delayMargin_s, 0.5 * Pi / K - t, 1e-13);
    int phases = 0;
    for (const Crossing& crossing : allCrossings(loop)) {
        if (crossing.kind == Crossing::Kind::Phase) {
            EXPECT_NEAR(crossing.frequency_rad_s * t, Pi * (0.5 + 2.0 * phases), 1e-9);
            ++phases;
        }
    }
    EXPECT_EQ(phases, 5); // up to |L| = 0.01, a little beyond 300 rad/s = (0.5 + 2 * 4.5) pi/t
}

// Second route: all gain crossings of a rational loop are roots of N(jw) N(-jw) - D(jw) D(-jw).
TEST(Margins, findsEveryGainCrossingOfRandomLoops) {
    Random random(21);
    int several = 0;
    for (int round = 0; round < 200; ++round) {
        const auto loop = randomSystem(random, 2 + static_cast<int>(random.below(5)), false);
        // p(s) p(-s) in x = -s^2 = w^2, from the even coefficients.
        const auto square = [](const Polynomial& p) {
            Polynomial mirrored = p;
            for (std::size_t i = 0; i < p.size(); ++i) {
                mirrored[i] *= (p.size() - 1 - i) % 2 == 0 ? 1.0 : -1.0;
            }
            const Polynomial product = multiply(p, mirrored);
            Polynomial even;
            for (std::size_t i = 0; i < product.size(); i += 2) {
                even.push_back(product[i] * (((product.size() - 1 - i) / 2) % 2 == 0 ? 1.0 : -1.0));
            }
            return even;
        };
        std::vector<double> expected;
        const auto difference = add(square(loop.numerator()), scale(square(loop.denominator()), -1.0));
        for (const auto& x : roots(difference)) {
            if (x.imag() == 0.0 && x.real() > 0.0) {
                expected.push_back(std::sqrt(x.real()));
            }
        }
        std::sort(expected.begin(), expected.end());
        std::vector<double> found;
        for (const Crossing& crossing : allCrossings(loop)) {
            if (crossing.kind == Crossing::Kind::Gain) {
                found.push_back(crossing.frequency_rad_s);
            }
        }
        ASSERT_EQ(found.size(), expected.size()) << round;
        for (std::size_t i = 0; i < found.size(); ++i) {
            // Neighbouring crossings make the squared polynomial ill-conditioned.
            EXPECT_NEAR(found[i], expected[i], 1e-9 * expected[i]) << round;
        }
        several += found.size() > 1 ? 1 : 0;
    }
    EXPECT_GT(several, 20);
}

// What was computed at 40 points a decade and what was computed exactly: straight lines over 6 % of
// frequency.
TEST(Margins, ofAMeasuredLoopAreThoseOfTheLoopThatWasMeasured) {
    const auto loop = *DeadTimeSystem::make(continuous({4.0}, {0.1, 1.0, 0.0}), 0.05);
    const StabilityMargins exact = smallestMargins(loop);
    const auto measured = frequencyResponse(loop, logarithmicFrequencies(0.1, 1000.0, 161));
    const StabilityMargins read = smallestMargins(*measured);
    // An eighth of the curvature times the step squared: (0.0576)^2/8 of log |L| and of the phase, each of
    // which bends by at most about two in a unit of log frequency: 1e-3, and 0.05 degrees; the delay has
    // both.
    EXPECT_NEAR(*read.gainCrossover_rad_s / *exact.gainCrossover_rad_s, 1.0, 1e-3);
    EXPECT_NEAR(read.phaseMargin_deg, exact.phaseMargin_deg, 0.05);
    EXPECT_NEAR(read.gainMargin_ratio / exact.gainMargin_ratio, 1.0, 1e-3);
    EXPECT_NEAR(read.delayMargin_s / exact.delayMargin_s, 1.0, 3e-3);
    EXPECT_NEAR(read.modulusMargin / exact.modulusMargin, 1.0, 1e-3);
}

// Points left out around the crossover leave a hole that nothing is read from.
TEST(Margins, aHoleInAMeasuredLoopHidesItsCrossing) {
    const auto loop = continuous({4.0}, {0.1, 1.0, 0.0});
    auto measured = *frequencyResponse(loop, {0.5, 1.0, 2.0, 8.0, 16.0});
    EXPECT_TRUE(allCrossings(measured).empty());
    EXPECT_TRUE(std::isinf(smallestMargins(measured).phaseMargin_deg));
}

// Second order, wn^2/(s^2 + 2 z wn s) : T is the plain second order system with its closed-form peak.
TEST(SensitivityPeaks, ofASecondOrderLoopAreTheClosedForms) {
    const double w = 7.0;
    const double zeta = 0.2;
    const auto loop = continuous({w * w}, {1.0, 2.0 * zeta * w, 0.0});
    const SensitivityPeaks peaks = sensitivityPeaks(loop);
    EXPECT_NEAR(peaks.Mt_ratio, 1.0 / (2.0 * zeta * std::sqrt(1.0 - zeta * zeta)), 1e-9);
    // The place of a peak is known to the root of the rounding of its height, some 1e-7 of w.
    EXPECT_NEAR(peaks.MtFrequency_rad_s, w * std::sqrt(1.0 - 2.0 * zeta * zeta), 1e-5);
    // |S|^2 = x (x + 4 z^2)/((1 - x)^2 + 4 z^2 x), x = (w/wn)^2, is largest at x = (1 + sqrt(1 + 8 z^2))/2.
    const double x = 0.5 * (1.0 + std::sqrt(1.0 + 8.0 * zeta * zeta));
    const double square = x * (x + 4.0 * zeta * zeta) / ((1.0 - x) * (1.0 - x) + 4.0 * zeta * zeta * x);
    EXPECT_NEAR(peaks.Ms_ratio, std::sqrt(square), 1e-9);
    EXPECT_NEAR(peaks.MsFrequency_rad_s, w * std::sqrt(x), 1e-5);
}

TEST(SensitivityPeaks, boundTheMarginsOfEveryStableLoop) {
    Random random(9);
    for (int round = 0; round < 50; ++round) {
        const auto loop = *DeadTimeSystem::make(randomSystem(random, 3, true), 0.01);
        const SensitivityPeaks peaks = sensitivityPeaks(loop);
        const StabilityMargins margins = smallestMargins(loop);
        EXPECT_NEAR(peaks.Ms_ratio * margins.modulusMargin, 1.0, 1e-12);
        EXPECT_GE(std::abs(margins.phaseMargin_deg),
                  radiansToDegrees(2.0 * std::asin(0.5 / peaks.Ms_ratio)) - 1e-6);
    }
}

TEST(LoopFunctions, sensitivityAndItsComplementAddUpToOne) {
    const auto plant = continuous({4.0}, {1.0, 1.0, 0.0});
    const auto controller = continuous({0.2, 1.0}, {0.01, 1.0});
    const auto functions = loopFunctions(plant, controller);
    ASSERT_TRUE(functions.has_value());
    for (const double w : {0.1, 1.0, 3.0, 100.0}) {
        const auto P = plant.atFrequency(w);
        const auto C = controller.atFrequency(w);
        EXPECT_LT(std::abs(functions->S.atFrequency(w) + functions->T.atFrequency(w) - 1.0), 1e-13);
        EXPECT_LT(std::abs(functions->PS.atFrequency(w) - P / (1.0 + P * C)), 1e-13 * (1.0 + std::abs(P)));
        EXPECT_LT(std::abs(functions->CS.atFrequency(w) - C / (1.0 + P * C)), 1e-12);
    }
}

TEST(LoopFunctions, anUnstableCancellationStaysVisible) {
    const auto functions = loopFunctions(continuous({1.0}, {1.0, -1.0}), continuous({1.0, -1.0}, {1.0, 2.0}));
    ASSERT_TRUE(functions.has_value());
    EXPECT_FALSE(isStable(functions->S));
}

// Second order: peak 1/(2 zeta sqrt(1 - zeta^2)) at w_n sqrt(1 - 2 zeta^2).
TEST(LoopFunctions, peakOfASecondOrderSystemIsTheClosedForm) {
    const double zeta = 0.1;
    const double w = 7.0;
    const ResponsePeak peak = peakMagnitude(continuous({w * w}, {1.0, 2.0 * zeta * w, w * w}));
    EXPECT_NEAR(peak.magnitude_ratio, 1.0 / (2.0 * zeta * std::sqrt(1.0 - zeta * zeta)), 1e-9);
    // The place is known to the root of the rounding.
    EXPECT_NEAR(peak.frequency_rad_s, w * std::sqrt(1.0 - 2.0 * zeta * zeta), 1e-5);
}

TEST(LoopFunctions, bandwidthOfALagIsItsCorner) {
    EXPECT_NEAR(bandwidth_rad_s(continuous({12.0}, {1.0, 3.0})).value(), 3.0, 1e-9);
    EXPECT_FALSE(bandwidth_rad_s(continuous({1.0, 4.0}, {1.0, 3.0})).has_value());
}

} // namespace
} // namespace halbench::control
