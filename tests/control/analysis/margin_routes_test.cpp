// Margins and peaks of random loops, continuous and sampled, by matrices: poles of the loop that is closed
// over the margin lie on the limit of stability; the largest sensitivity is the norm that the Hamiltonian
// matrix gives; all crossings are the roots of a polynomial without a grid.
#include "control/analysis/loop_functions.h"
#include "control/analysis/margins.h"
#include "control/base/units.h"
#include "control/lti/state_response.h"
#include "tests/control/routes/random_loops.h"
#include "tests/control/routes/state_routes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

using Complex = std::complex<double>;

/// How far a pole may be from where it belongs when the gain is known to `gain_ratio`: dx/dlnK = -L/L', with
/// the slope of L along the boundary by a central difference.
double poleTolerance(const TransferFunction& loop, double frequency_rad_s, double gain_ratio) {
    const double step_rad_s = 1e-5 * frequency_rad_s;
    const Complex slope =
        (loop.atFrequency(frequency_rad_s + step_rad_s) - loop.atFrequency(frequency_rad_s - step_rad_s)) /
        (2.0 * step_rad_s);
    const double scale = loop.timeBase().isSampled() ? loop.timeBase().period_s() : 1.0;
    return gain_ratio * scale * std::abs(loop.atFrequency(frequency_rad_s) / slope);
}

// 1e-9 of the margin and what rounding of the polynomials costs there, beside 1e-12 for the eigenvalues.
TEST(MarginRoutes, theLoopClosedOverAMarginHasAPoleOnTheLimitOfStability) {
    Random random(101);
    int gains = 0;
    int phases = 0;
    for (int round = 0; round < 300; ++round) {
        const auto [loop, states] = randomLoop(random, round);
        for (const Crossing& crossing : allCrossings(loop)) {
            const double w = crossing.frequency_rad_s;
            const bool isGain = crossing.kind == Crossing::Kind::Gain;
            // Gain crossing: L turned by the margin is -1. Phase crossing: L times the margin is -1.
            const Complex factor = isGain ? std::polar(1.0, -degreesToRadians(crossing.phaseMargin_deg))
                                          : Complex(crossing.gainMargin_ratio, 0.0);
            const Complex place = boundaryPoint(loop.timeBase(), w);
            const double tolerance = poleTolerance(loop, w, 1e-9 + 100.0 * roundingOf(loop, w));
            EXPECT_LT(distanceTo(closedPoles(states, factor), place),
                      tolerance + 1e-11 * std::max(1.0, std::abs(place)))
                << round << " at " << w;
            (isGain ? gains : phases) += 1;
        }
    }
    EXPECT_GT(gains, 150);
    EXPECT_GT(phases, 100);
}

/// Frequencies at which L is real and negative: roots of the odd part of N(s) D(-s).
std::vector<double> negativeRealContinuous(const TransferFunction& loop) {
    Polynomial mirrored = loop.denominator();
    for (std::size_t i = 0; i < mirrored.size(); ++i) {
        mirrored[i] *= (mirrored.size() - 1 - i) % 2 == 0 ? 1.0 : -1.0;
    }
    const Polynomial product = multiply(loop.numerator(), mirrored);
    Polynomial odd; // in x = w^2 = -s^2
    for (std::size_t i = product.size() % 2; i < product.size(); i += 2) {
        const std::size_t power = product.size() - 1 - i;
        odd.push_back(product[i] * (power / 2 % 2 == 0 ? 1.0 : -1.0));
    }
    std::vector<double> found;
    for (const Complex& x : roots(odd)) {
        if (x.imag() == 0.0 && x.real() > 0.0 && loop.atFrequency(std::sqrt(x.real())).real() < 0.0) {
            found.push_back(std::sqrt(x.real()));
        }
    }
    return found;
}

/// The same on the unit circle: roots of N(z) D(1/z) - N(1/z) D(z), and the Nyquist frequency itself.
std::vector<double> negativeRealSampled(const TransferFunction& loop) {
    Polynomial N = loop.numerator();
    N.insert(N.begin(), loop.denominator().size() - N.size(), 0.0);
    const Polynomial& D = loop.denominator();
    const Polynomial backN(N.rbegin(), N.rend());
    const Polynomial backD(D.rbegin(), D.rend());
    const double T = loop.timeBase().period_s();
    std::vector<double> found;
    for (const Complex& z : roots(add(multiply(N, backD), scale(multiply(backN, D), -1.0)))) {
        // Roots of a polynomial that is its own mirror image lie on the circle to rounding, or clearly not.
        if (std::abs(std::abs(z) - 1.0) < 1e-7 && std::arg(z) > 1e-3 && std::arg(z) < Pi - 1e-6 &&
            loop.at(z).real() < 0.0) {
            found.push_back(std::arg(z) / T);
        }
    }
    if (loop.at({-1.0, 0.0}).real() < 0.0) {
        found.push_back(Pi / T);
    }
    return found;
}

// Crossings below w T = 1e-3 are left out on both sides: integrators make roots of several at z = 1.
TEST(MarginRoutes, everyPhaseCrossingIsARootAndEveryRootAPhaseCrossing) {
    Random random(102);
    int several = 0;
    for (int round = 0; round < 300; ++round) {
        const auto [loop, states] = randomLoop(random, round);
        const bool isSampled = loop.timeBase().isSampled();
        std::vector<double> expected = isSampled ? negativeRealSampled(loop) : negativeRealContinuous(loop);
        std::sort(expected.begin(), expected.end());
        std::vector<double> found;
        for (const Crossing& crossing : allCrossings(loop)) {
            const double w = crossing.frequency_rad_s;
            if (crossing.kind == Crossing::Kind::Phase && (!isSampled || w * 0.05 > 1e-3)) {
                found.push_back(w);
            }
        }
        ASSERT_EQ(found.size(), expected.size()) << round;
        for (std::size_t i = 0; i < found.size(); ++i) {
            // Products of two polynomials: twice the digits of one are lost, and neighbours share theirs.
            const double rounding_ratio = 1e4 * roundingOf(loop, found[i]);
            EXPECT_NEAR(found[i] / expected[i], 1.0, 1e-9 + rounding_ratio) << round;
        }
        several += found.size() > 1 ? 1 : 0;
    }
    EXPECT_GT(several, 20);
}

// 1e-9 of the matrices' own bound, and what the polynomials lose at the peak.
TEST(MarginRoutes, peaksOfSensitivityAreTheNormsOfTheirMatrices) {
    Random random(103);
    int resonant = 0;
    for (int round = 0; round < 200; ++round) {
        const auto [loop, states] = randomLoop(random, round);
        const SensitivityPeaks peaks = sensitivityPeaks(loop);
        const double Ms = largestMagnitude(sensitivityOf(states));
        const double Mt = largestMagnitude(complementOf(states));
        const auto rounding = [&](double w) { return 100.0 * roundingOf(loop, w); };
        EXPECT_NEAR(peaks.Ms_ratio / Ms, 1.0, 2e-9 + rounding(peaks.MsFrequency_rad_s)) << round;
        EXPECT_NEAR(smallestMargins(loop).modulusMargin * Ms, 1.0, 2e-9 + rounding(peaks.MsFrequency_rad_s))
            << round;
        EXPECT_NEAR(peaks.Mt_ratio / Mt, 1.0, 2e-9 + rounding(peaks.MtFrequency_rad_s)) << round;
        resonant += Ms > 1.05 ? 1 : 0;
    }
    EXPECT_GT(resonant, 100);
}

// L = -0.97/(s + 1): S is 1/0.03 at rest and falls from 0.03 rad/s on, far below the slowest open pole.
TEST(MarginRoutes, aPeakAtRestIsNotMissedBelowTheScan) {
    const auto loop = *TransferFunction::make({-0.97}, {1.0, 1.0}, TimeBase::continuous());
    EXPECT_NEAR(sensitivityPeaks(loop).Ms_ratio * 0.03, 1.0, 1e-13);
    EXPECT_NEAR(smallestMargins(loop).modulusMargin, 0.03, 1e-15);
    EXPECT_DOUBLE_EQ(
        peakMagnitude(*TransferFunction::make({2.0}, {1.0, 1.0}, TimeBase::continuous())).magnitude_ratio,
        2.0);
}

TEST(MarginRoutes, theLargestMagnitudeOfAStableSystemIsTheNormOfItsMatrices) {
    Random random(104);
    for (int round = 0; round < 150; ++round) {
        const bool isSampled =
            round % 2 == 1; // whose polynomials of high order are other systems to rounding
        const int order = 1 + static_cast<int>(random.below(isSampled ? 4 : 6));
        const auto continuous = randomSystem(random, order, true, round % 4 < 2);
        const auto system = isSampled ? *discretize(continuous, 0.05, Hold::Zoh{}) : continuous;
        const ResponsePeak peak = peakMagnitude(system);
        EXPECT_NEAR(peak.magnitude_ratio / largestMagnitude(sectionsOf(system)), 1.0,
                    2e-9 + 100.0 * roundingOf(system, peak.frequency_rad_s))
            << round;
    }
}

// |G|^2 = dc^2/2: the lowest imaginary eigenvalue of the Hamiltonian matrix at that level.
TEST(MarginRoutes, theBandwidthIsTheFirstFrequencyAtItsLevel) {
    Random random(105);
    int some = 0;
    for (int round = 0; round < 150; ++round) {
        const auto system = randomSystem(random, 1 + static_cast<int>(random.below(5)), true, round % 4 == 0);
        const auto frequencies =
            levelFrequencies(sectionsOf(system), std::abs(system.dcGain()) * std::sqrt(0.5));
        const auto found = bandwidth_rad_s(system);
        ASSERT_EQ(found.has_value(), !frequencies.empty()) << round;
        if (found) {
            EXPECT_NEAR(*found / frequencies.front(), 1.0, 1e-9) << round;
            ++some;
        }
    }
    EXPECT_GT(some, 80);
}

// Polynomials against matrices: all four functions of random plants and controllers.
TEST(MarginRoutes, loopFunctionsAreTheFeedbackOfTheMatrices) {
    Random random(106);
    for (int round = 0; round < 100; ++round) {
        const bool isSampled = round % 2 == 1;
        const auto draw = [&](bool isProper) {
            const auto system = randomSystem(random, 1 + static_cast<int>(random.below(3)), false, isProper);
            return isSampled ? *discretize(system, 0.05, Hold::Zoh{}) : system;
        };
        const TransferFunction plant = draw(false);
        const TransferFunction controller = draw(true);
        const auto functions = loopFunctions(plant, controller);
        ASSERT_TRUE(functions.has_value()) << round;
        const StateSpace P = sectionsOf(plant);
        const StateSpace C = sectionsOf(controller);
        const StateSpace one = toStateSpace(TransferFunction::gain(1.0, plant.timeBase()));
        const StateSpace L = *series(C, P);
        const std::pair<TransferFunction, StateSpace> pairs[] = {{functions->S, *feedback(one, L)},
                                                                 {functions->T, *feedback(L, one)},
                                                                 {functions->PS, *feedback(P, C)},
                                                                 {functions->CS, *feedback(C, P)}};
        for (const double w : {0.3, 2.0, 25.0}) {
            for (const auto& [rational, states] : pairs) {
                const Complex expected = StatePath(states).atFrequency(w);
                EXPECT_LT(std::abs(rational.atFrequency(w) - expected),
                          (1e-9 + 100.0 * roundingOf(rational, w)) * std::abs(expected))
                    << round << " at " << w;
            }
        }
    }
}

} // namespace
} // namespace halbench::control
