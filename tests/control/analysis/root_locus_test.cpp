#include "control/analysis/root_locus.h"
#include "control/base/units.h"
#include "control/lti/discretize.h"
#include "tests/control/random_systems.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

using Complex = std::complex<double>;

TransferFunction continuous(Polynomial numerator, Polynomial denominator) {
    return *TransferFunction::make(std::move(numerator), std::move(denominator), TimeBase::continuous());
}

// s^2 + 2 s + K: the poles meet at -1 at K = 1 and leave along Re s = -1.
TEST(RootLocus, ofTwoRealPolesIsTheQuadraticFormula) {
    const auto locus = rootLocus(continuous({1.0}, {1.0, 2.0, 0.0}), 10.0);
    ASSERT_TRUE(locus.has_value());
    ASSERT_EQ(locus->breakaways.size(), 1u);
    EXPECT_NEAR(locus->breakaways[0].point.real(), -1.0, 1e-12);
    EXPECT_NEAR(locus->breakaways[0].gain, 1.0, 1e-12);
    EXPECT_DOUBLE_EQ(locus->gain.back(), 10.0);
    EXPECT_EQ(locus->asymptoteCentroid, -1.0);
    ASSERT_EQ(locus->asymptoteAngles_rad.size(), 2u);
    EXPECT_NEAR(locus->asymptoteAngles_rad[0], Pi / 2.0, 1e-15);
    for (std::size_t i = 0; i < locus->gain.size(); ++i) {
        const double K = locus->gain[i];
        const Complex root = std::sqrt(Complex(1.0 - K, 0.0));
        const double first = std::min(std::abs(locus->branch[0][i] - (-1.0 + root)),
                                      std::abs(locus->branch[0][i] - (-1.0 - root)));
        // At the double root half of the digits are left.
        EXPECT_LT(first, std::abs(K - 1.0) < 1e-6 ? 1e-7 : 1e-9) << K;
    }
}

// K/(s (s + 1)(s + 2)): the axis is crossed at K = 6, w = sqrt 2; breakaway at -1 + 1/sqrt 3; centroid -1.
TEST(RootLocus, ofTheTextbookExampleHasItsFigures) {
    const auto locus = rootLocus(continuous({1.0}, {1.0, 3.0, 2.0, 0.0}));
    ASSERT_TRUE(locus.has_value());
    ASSERT_EQ(locus->axisCrossings.size(), 1u);
    EXPECT_NEAR(locus->axisCrossings[0].gain, 6.0, 1e-9);
    EXPECT_NEAR(locus->axisCrossings[0].frequency_rad_s, std::sqrt(2.0), 1e-9);
    ASSERT_EQ(locus->breakaways.size(), 1u);
    EXPECT_NEAR(locus->breakaways[0].point.real(), -1.0 + 1.0 / std::sqrt(3.0), 1e-10);
    EXPECT_NEAR(locus->breakaways[0].gain, 2.0 / (3.0 * std::sqrt(3.0)), 1e-10);
    EXPECT_DOUBLE_EQ(locus->asymptoteCentroid, -1.0);
    ASSERT_EQ(locus->asymptoteAngles_rad.size(), 3u);
    EXPECT_NEAR(locus->asymptoteAngles_rad[0], Pi / 3.0, 1e-15);
    // Far out every branch lies on its ray.
    for (const auto& branch : locus->branch) {
        const double angle_rad = std::arg(branch.back() + 1.0);
        double nearest = HUGE_VAL;
        for (const double ray : locus->asymptoteAngles_rad) {
            nearest = std::min(nearest, std::abs(std::arg(std::polar(1.0, angle_rad - ray))));
        }
        EXPECT_LT(nearest, 0.02);
    }
}

// Each point is a pole of its closed loop, and no branch jumps: neighbours lie within a hundredth of the
// picture.
TEST(RootLocus, branchesOfRandomLoopsAreContinuousAndComplete) {
    Random random(51);
    for (int round = 0; round < 60; ++round) {
        const auto loop = randomSystem(random, 1 + static_cast<int>(random.below(5)), true, round % 5 == 0);
        const auto locus = rootLocus(loop);
        ASSERT_TRUE(locus.has_value());
        ASSERT_EQ(locus->branch.size(), static_cast<std::size_t>(loop.order()));
        EXPECT_TRUE(std::is_sorted(locus->gain.begin(), locus->gain.end()));
        EXPECT_LT(locus->gain.size(), 19000u) << round;
        double extent = 0.0;
        for (const auto& branch : locus->branch) {
            for (const Complex& point : branch) {
                extent = std::max(extent, std::abs(point));
            }
        }
        for (std::size_t i = 1; i < locus->gain.size(); ++i) {
            auto expected = roots(add(loop.denominator(), scale(loop.numerator(), locus->gain[i])));
            for (const auto& branch : locus->branch) {
                // A hundredth of the picture, and three where branches meet and leave at right angles.
                EXPECT_LT(std::abs(branch[i] - branch[i - 1]), 0.03 * extent) << round;
                const auto nearest =
                    std::min_element(expected.begin(), expected.end(), [&](Complex a, Complex b) {
                        return std::abs(a - branch[i]) < std::abs(b - branch[i]);
                    });
                EXPECT_LT(std::abs(*nearest - branch[i]), 1e-9 * extent) << round;
                expected.erase(nearest);
            }
        }
    }
}

// The identity of a branch survives a near miss: the motion of a pole and its velocity dx/dK = -N/(D' + K N')
// agree all along it.
TEST(RootLocus, aBranchMovesAlongItsOwnVelocity) {
    const auto loop = continuous({1.0, 2.0}, multiply({1.0, 0.4, 4.0}, {1.0, 0.5, 4.4}));
    const auto locus = rootLocus(loop);
    ASSERT_TRUE(locus.has_value());
    const auto slope = [](const Polynomial& p, Complex x) {
        Complex value = 0.0;
        for (std::size_t i = 0; i + 1 < p.size(); ++i) {
            value = value * x + p[i] * static_cast<double>(p.size() - 1 - i);
        }
        return value;
    };
    int checked = 0;
    for (std::size_t i = 1; i < locus->gain.size(); ++i) {
        const double step = locus->gain[i] - locus->gain[i - 1];
        for (const auto& branch : locus->branch) {
            const Complex middle = 0.5 * (branch[i] + branch[i - 1]);
            const double K = 0.5 * (locus->gain[i] + locus->gain[i - 1]);
            const Complex velocity =
                -evaluate(loop.numerator(), middle) /
                (slope(loop.denominator(), middle) + K * slope(loop.numerator(), middle));
            const Complex move = branch[i] - branch[i - 1];
            if (std::abs(move) > 1e-6) { // otherwise the difference has no digits
                EXPECT_LT(std::abs(move - velocity * step), 0.2 * std::abs(move)) << K;
                ++checked;
            }
        }
    }
    EXPECT_GT(checked, 200);
}

// Sampled double integrator with a lead, as the published motor's: the branches leave the unit circle at the
// gain margin.
TEST(RootLocus, sampledBranchesLeaveTheUnitCircleAtTheLimit) {
    const auto loop = *discretize(continuous({26.0}, {1.0, 2.236364, 0.0}), 0.01, Hold::Zoh{});
    const auto locus = rootLocus(loop, 30.0);
    ASSERT_TRUE(locus.has_value());
    ASSERT_FALSE(locus->axisCrossings.empty());
    EXPECT_NEAR(locus->axisCrossings[0].gain, 17.27, 0.01); // help: htm-theory.md 5
    for (std::size_t i = 1; i < locus->gain.size(); ++i) {
        const double radius = std::max(std::abs(locus->branch[0][i]), std::abs(locus->branch[1][i]));
        if (std::abs(locus->gain[i] / locus->axisCrossings[0].gain - 1.0) > 1e-6) {
            EXPECT_EQ(radius < 1.0, locus->gain[i] < locus->axisCrossings[0].gain) << locus->gain[i];
        }
    }
}

TEST(RootLocus, refusesWhatHasNoBranches) {
    EXPECT_EQ(rootLocus(TransferFunction::gain(2.0, TimeBase::continuous())).error().code,
              ErrorCode::InvalidInput);
    EXPECT_EQ(rootLocus(continuous({1.0}, {1.0, 1.0}), -1.0).error().code, ErrorCode::OutOfRange);
}

} // namespace
} // namespace halbench::control
