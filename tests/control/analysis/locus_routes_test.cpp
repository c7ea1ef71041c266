// Root locus and Nyquist count of random loops against the eigenvalues of A - K B C.
#include "control/analysis/locus_gain.h"
#include "control/analysis/nyquist.h"
#include "control/analysis/root_locus.h"
#include "tests/control/routes/own_loop.h"
#include "tests/control/routes/random_loops.h"
#include "tests/control/routes/state_routes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace halbench::control {
namespace {

using Complex = std::complex<double>;

double extentOf(const RootLocus& locus) {
    double extent = 0.0;
    for (const auto& branch : locus.branch) {
        for (const Complex& point : branch) {
            extent = std::max(extent, std::abs(point));
        }
    }
    return extent;
}

/// A root moves by what the rounding of the polynomial is there, over the product of its distances to the
/// others; where they meet that is no bound, and half of the digits are left.
double rootTolerance(const TransferFunction& loop, double gain, const std::vector<Complex>& others,
                     Complex pole) {
    const Polynomial closed = add(loop.denominator(), scale(loop.numerator(), gain));
    double terms = 0.0;
    for (std::size_t i = 0; i < closed.size(); ++i) {
        terms = terms * std::abs(pole) + std::abs(closed[i]);
    }
    double product = std::abs(closed.front());
    for (const Complex& other : others) {
        product *= std::abs(other - pole);
    }
    return 1e4 * std::numeric_limits<double>::epsilon() * terms / product;
}

/// Each eigenvalue is on one branch.
void expectSamePoles(const TransferFunction& loop, const RootLocus& locus, std::size_t i,
                     const StateSpace& states, double extent) {
    const Eigen::VectorXcd poles = closedPoles(states, locus.gain[i]);
    // Eigenvalues are right to the rounding of their matrix.
    const double ofMatrix = 1e2 * std::numeric_limits<double>::epsilon() *
                            (states.A.norm() + locus.gain[i] * states.B.norm() * states.C.norm());
    std::vector<Complex> left(poles.begin(), poles.end());
    ASSERT_EQ(left.size(), locus.branch.size());
    for (const auto& branch : locus.branch) {
        const auto nearest = std::min_element(left.begin(), left.end(), [&](Complex a, Complex b) {
            return std::abs(a - branch[i]) < std::abs(b - branch[i]);
        });
        std::vector<Complex> others(poles.begin(), poles.end());
        others.erase(std::find(others.begin(), others.end(), *nearest));
        const double moved = rootTolerance(loop, locus.gain[i], others, *nearest);
        // Two samples of delay at K = 0 are a Jordan block, whose eigenvalues know half of the digits.
        const double ofDelay = branch[i] == 0.0 ? 1e-6 : 0.0;
        EXPECT_LT(std::abs(*nearest - branch[i]),
                  1e-9 * extent + ofMatrix + ofDelay + std::min(moved, 1e-5 * extent))
            << "gain " << locus.gain[i];
        left.erase(nearest);
    }
}

TEST(LocusRoutes, everyBranchRunsThroughTheEigenvaluesOfItsGain) {
    Random random(111);
    for (int round = 0; round < 40; ++round) {
        const auto [loop, states] = randomLoop(random, round);
        const auto locus = rootLocus(loop);
        ASSERT_TRUE(locus.has_value()) << round;
        const double extent = extentOf(*locus);
        // Every branch at some fifty gains, the first and the last among them.
        const std::size_t stride = std::max<std::size_t>(1, locus->gain.size() / 50);
        for (std::size_t i = 0; i < locus->gain.size(); i += stride) {
            expectSamePoles(loop, *locus, i, states, extent);
        }
    }
}

// The count of unstable eigenvalues changes at the crossings of the limit and nowhere else.
TEST(LocusRoutes, stabilityChangesAtTheAxisCrossingsOnly) {
    Random random(112);
    int crossings = 0;
    for (int round = 0; round < 60; ++round) {
        const auto [loop, states] = randomLoop(random, round);
        const auto locus = rootLocus(loop);
        ASSERT_TRUE(locus.has_value()) << round;
        // Integrators begin on the limit: below 1e-6 rounding of the eigenvalues says on which side.
        for (const auto& crossing : locus->axisCrossings) {
            const double before = crossing.gain * (1.0 - 1e-6);
            const double after = crossing.gain * (1.0 + 1e-6);
            if (crossing.gain > 1e-6 && after < locus->gain.back()) {
                EXPECT_NE(unstableCount(states, before), unstableCount(states, after))
                    << round << " at " << crossing.gain;
                ++crossings;
            }
        }
        std::vector<double> edges = {std::max(1e-6, 1e-6 * locus->gain.back())};
        for (const auto& crossing : locus->axisCrossings) {
            edges.push_back(crossing.gain);
        }
        edges.push_back(locus->gain.back());
        for (std::size_t i = 1; i < edges.size(); ++i) {
            if (edges[i - 1] < edges[i] * (1.0 - 1e-4) && edges[i - 1] >= edges.front()) {
                const double low = edges[i - 1] * (1.0 + 1e-5);
                const double high = edges[i] * (1.0 - 1e-5);
                EXPECT_EQ(unstableCount(states, low), unstableCount(states, std::sqrt(low * high))) << round;
                EXPECT_EQ(unstableCount(states, high), unstableCount(states, std::sqrt(low * high))) << round;
            }
        }
    }
    EXPECT_GT(crossings, 30);
}

// The poles of a loop with integrators leave z = 1 where they begin: at rest nothing is crossed, whatever the
// rounding of their polynomial says there (a gain of 1e-13 to 1e-8, of either sign).
TEST(LocusRoutes, integratorsCrossNothingAtRest) {
    Random random(114);
    int deceiving = 0;
    for (int round = 0; round < 300; ++round) {
        const OwnLoop own = randomStableLoop(random);
        const auto position = sampledOpenLoop(own.plant, own.gains, own.timing);
        const auto [rational, states] = randomLoop(random, 6 * round); // sampled, with an integrator or two
        for (const TransferFunction& loop : {*position, rational}) {
            const double rest = loop.dcGain();
            deceiving += std::isfinite(rest) && rest < 0.0 ? 1 : 0;
            const auto locus = rootLocus(loop, 4.0);
            ASSERT_TRUE(locus.has_value()) << round;
            for (const auto& crossing : locus->axisCrossings) {
                EXPECT_GT(crossing.frequency_rad_s, 0.0) << round << ": gain " << crossing.gain;
            }
        }
    }
    EXPECT_GT(deceiving, 100);
}

// An unstable pole beside a large gain: 1e9/(s - 1), stable above 1e-9, and the same sampled; two such poles
// and a zero. The crossing is at rest, and true.
TEST(LocusRoutes, aTrueCrossingAtAVerySmallGainIsKept) {
    const auto continuous = *TransferFunction::make({1e9}, {1.0, -1.0}, TimeBase::continuous());
    const auto sampled = *discretize(continuous, 0.05, Hold::Zoh{});
    const auto slow = *TransferFunction::make({1e9}, {1.0, -1.0 - 1e-6}, TimeBase::sampled(0.05));
    for (const auto& [loop, gain] :
         {std::pair(continuous, 1e-9), std::pair(sampled, 1e-9), std::pair(slow, 1e-15)}) {
        const auto locus = rootLocus(loop, 1.0);
        ASSERT_TRUE(locus.has_value());
        ASSERT_FALSE(locus->axisCrossings.empty()) << gain;
        EXPECT_EQ(locus->axisCrossings.front().frequency_rad_s, 0.0);
        // 1 + 1e-6 less 1 has ten digits.
        EXPECT_NEAR(locus->axisCrossings.front().gain / gain, 1.0, 1e-9);
        EXPECT_EQ(unstableCount(sectionsOf(loop), 0.9 * gain), 1);
        EXPECT_EQ(unstableCount(sectionsOf(loop), 1.1 * gain), 0);
    }
}

// Two eigenvalues meet there: apart by the root of what the gain is uncertain.
TEST(LocusRoutes, breakawaysAreDoubleEigenvalues) {
    Random random(113);
    int checked = 0;
    for (int round = 0; round < 60; ++round) {
        const TransferFunction loop = randomSystem(random, 2 + static_cast<int>(random.below(3)), true);
        const auto locus = rootLocus(loop);
        ASSERT_TRUE(locus.has_value()) << round;
        for (const auto& breakaway : locus->breakaways) {
            const auto poles = closedPoles(sectionsOf(loop), breakaway.gain);
            int near = 0;
            for (const Complex& pole : poles) {
                near += std::abs(pole - breakaway.point) < 1e-5 * (1.0 + std::abs(breakaway.point)) ? 1 : 0;
            }
            EXPECT_EQ(near, 2) << round << " at " << breakaway.gain;
            ++checked;
        }
    }
    EXPECT_GT(checked, 20);
}

// Back from the place of an eigenvalue to the gain that put it there, along straight lines between points
// that lie a hundredth of the picture apart.
TEST(LocusRoutes, theGainOfAnEigenvalueIsReadOffItsBranch) {
    Random random(114);
    for (int round = 0; round < 40; ++round) {
        const TransferFunction loop = randomSystem(random, 2 + static_cast<int>(random.below(3)), true);
        const auto locus = rootLocus(loop);
        ASSERT_TRUE(locus.has_value()) << round;
        const double gain =
            std::sqrt(locus->gain[locus->gain.size() / 3] * locus->gain[locus->gain.size() / 2]);
        const StateSpace states = sectionsOf(loop);
        const Eigen::VectorXcd all = closedPoles(states, gain);
        for (const Complex& pole : all) {
            const auto branch = branchAt(*locus, gain, pole);
            ASSERT_TRUE(branch.has_value());
            const double read = gainNearest(*locus, *branch, pole);
            const double away = distanceTo(closedPoles(states, read), pole);
            EXPECT_LT(away, 2e-3 * extentOf(*locus)) << round << ' ' << gain << ' ' << read;
        }
    }
}

// The count by turns of the curve against eigenvalues of the matrix, neither of which has the other's
// polynomial.
TEST(LocusRoutes, theNyquistCountIsThatOfTheEigenvalues) {
    Random random(115);
    int unstable = 0;
    for (int round = 0; round < 300; ++round) {
        const auto [loop, states] = randomLoop(random, round);
        const auto result = nyquist(loop);
        ASSERT_TRUE(result.has_value()) << round;
        EXPECT_EQ(result->unstableClosedLoopPoles, unstableCount(states, 1.0)) << round;
        unstable += result->unstableClosedLoopPoles > 0 ? 1 : 0;
    }
    EXPECT_GT(unstable, 50); // both answers occurred
    EXPECT_LT(unstable, 280);
}

} // namespace
} // namespace halbench::control
