#include "control/analysis/margins.h"
#include "control/analysis/nyquist.h"
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

/// Second route: the roots of the closed polynomial.
int unstableRoots(const TransferFunction& loop) {
    const auto closed = *feedback(loop, TransferFunction::gain(1.0, loop.timeBase()));
    int count = 0;
    for (const auto& pole : poles(closed)) {
        count += (loop.timeBase().isSampled() ? std::abs(pole) >= 1.0 : pole.real() >= 0.0) ? 1 : 0;
    }
    return count;
}

// K/(s (s+1)(s+2)) is stable up to K = 6 and has two unstable poles beyond.
TEST(Nyquist, countsTheUnstablePolesOfALoopWithAnIntegrator) {
    const auto stable = nyquist(continuous({5.9}, {1.0, 3.0, 2.0, 0.0}));
    ASSERT_TRUE(stable.has_value());
    EXPECT_EQ(stable->encirclements, 0);
    EXPECT_EQ(stable->unstableClosedLoopPoles, 0);
    const auto unstable = nyquist(continuous({6.1}, {1.0, 3.0, 2.0, 0.0}));
    ASSERT_TRUE(unstable.has_value());
    EXPECT_EQ(unstable->encirclements, -2);
    EXPECT_EQ(unstable->unstableClosedLoopPoles, 2);
}

// K/(s - 1) needs one counter-clockwise turn: K > 1.
TEST(Nyquist, anUnstableOpenLoopIsStabilisedByItsEncirclement) {
    const auto stable = nyquist(continuous({2.0}, {1.0, -1.0}));
    ASSERT_TRUE(stable.has_value());
    EXPECT_EQ(stable->unstableOpenLoopPoles, 1);
    EXPECT_EQ(stable->encirclements, 1);
    EXPECT_EQ(stable->unstableClosedLoopPoles, 0);
    EXPECT_EQ(nyquist(continuous({0.5}, {1.0, -1.0}))->unstableClosedLoopPoles, 1);
}

TEST(Nyquist, passesDoubleIntegratorsAndUndampedPairsOnTheirRight) {
    EXPECT_EQ(nyquist(continuous({1.0, 1.0}, {1.0, 0.0, 0.0}))->unstableClosedLoopPoles, 0);
    EXPECT_EQ(nyquist(continuous({1.0}, {1.0, 1.0, 0.0, 0.0}))->unstableClosedLoopPoles, 2);
    // (s + 1)/(s^2 + 4): the closed pair s^2 + s + 5 is stable; with a zero on the right it is not.
    EXPECT_EQ(nyquist(continuous({1.0, 1.0}, {1.0, 0.0, 4.0}))->unstableClosedLoopPoles, 0);
    EXPECT_EQ(nyquist(continuous({-1.0, 1.0}, {1.0, 0.0, 4.0}))->unstableClosedLoopPoles, 2);
}

TEST(Nyquist, refusesALoopOnTheLimitOfStability) {
    EXPECT_EQ(nyquist(continuous({6.0}, {1.0, 3.0, 2.0, 0.0})).error().code, ErrorCode::Refused);
}

TEST(Nyquist, theCurveStartsAndEndsOnTheRealAxisAndMarksItsArcs) {
    const auto result = nyquist(continuous({5.0}, {1.0, 3.0, 2.0, 0.0}));
    ASSERT_TRUE(result.has_value());
    EXPECT_NEAR(result->curve.front().value.imag(), 0.0, 1e-9 * std::abs(result->curve.front().value));
    EXPECT_TRUE(result->curve.front().isIndented);
    EXPECT_FALSE(result->curve.back().isIndented);
    EXPECT_LT(std::abs(result->curve.back().value), 1e-5); // 5/w^3 at 100 times the fastest pole
}

TEST(Nyquist, agreesWithTheRootsOfRandomClosedLoops) {
    Random random(3);
    int unstable = 0;
    for (int round = 0; round < 300; ++round) {
        TransferFunction loop =
            randomSystem(random, 1 + static_cast<int>(random.below(6)), false, round % 5 == 0);
        if (round % 3 == 0) { // one or two integrators
            Polynomial denominator = loop.denominator();
            denominator.resize(denominator.size() + 1 + random.below(2), 0.0);
            loop = continuous(loop.numerator(), denominator);
        }
        const auto result = nyquist(loop);
        ASSERT_TRUE(result.has_value()) << round;
        EXPECT_EQ(result->unstableClosedLoopPoles, unstableRoots(loop)) << round;
        unstable += result->unstableClosedLoopPoles > 0 ? 1 : 0;
    }
    EXPECT_GT(unstable, 50); // both answers occurred
    EXPECT_LT(unstable, 250);
}

TEST(Nyquist, agreesWithTheRootsOfRandomSampledLoops) {
    Random random(4);
    int unstable = 0;
    for (int round = 0; round < 200; ++round) {
        TransferFunction plant = randomSystem(random, 1 + static_cast<int>(random.below(3)), false);
        if (round % 2 == 0) {
            Polynomial denominator = plant.denominator();
            denominator.push_back(0.0);
            plant = continuous(plant.numerator(), denominator);
        }
        const auto loop = *series(*discretize(plant, 0.05, Hold::Zoh{}),
                                  TransferFunction::delay(static_cast<int>(random.below(3)), 0.05));
        const auto result = nyquist(loop);
        ASSERT_TRUE(result.has_value()) << round;
        EXPECT_EQ(result->unstableClosedLoopPoles, unstableRoots(loop)) << round;
        unstable += result->unstableClosedLoopPoles > 0 ? 1 : 0;
    }
    EXPECT_GT(unstable, 30);
    EXPECT_LT(unstable, 180);
}

// K exp(-s t)/s is stable for K t < pi/2 (Nyquist's own example of a loop with dead time).
TEST(Nyquist, countsWithTheExactDeadTime) {
    for (const double K : {0.2, 1.0, 30.0}) {
        const auto integrator = continuous({K}, {1.0, 0.0});
        const double limit_s = 0.5 * Pi / K;
        EXPECT_EQ(nyquist(*DeadTimeSystem::make(integrator, 0.999 * limit_s))->unstableClosedLoopPoles, 0);
        EXPECT_EQ(nyquist(*DeadTimeSystem::make(integrator, 1.001 * limit_s))->unstableClosedLoopPoles, 2);
        // The next pair follows one turn later.
        EXPECT_EQ(nyquist(*DeadTimeSystem::make(integrator, 5.001 * limit_s))->unstableClosedLoopPoles, 4);
    }
    EXPECT_EQ(nyquist(*DeadTimeSystem::make(continuous({2.0, 1.0}, {1.0, 3.0}), 0.1)).error().code,
              ErrorCode::InvalidInput);
}

// The delay margin is the dead time at which the count changes from none.
TEST(Nyquist, theDelayMarginIsWhereTheCountChanges) {
    Random random(5);
    int checked = 0;
    for (int round = 0; round < 60; ++round) {
        const auto loop = randomSystem(random, 1 + static_cast<int>(random.below(4)), true);
        const double margin_s = smallestMargins(loop).delayMargin_s;
        if (nyquist(loop)->unstableClosedLoopPoles > 0 || !std::isfinite(margin_s)) {
            continue;
        }
        EXPECT_EQ(nyquist(*DeadTimeSystem::make(loop, margin_s * (1.0 - 1e-6)))->unstableClosedLoopPoles, 0);
        EXPECT_GT(nyquist(*DeadTimeSystem::make(loop, margin_s * (1.0 + 1e-6)))->unstableClosedLoopPoles, 0);
        ++checked;
    }
    EXPECT_GT(checked, 10);
}

} // namespace
} // namespace halbench::control
