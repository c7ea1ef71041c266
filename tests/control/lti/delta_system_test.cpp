#include "control/lti/conjugate_pairs.h"
#include "control/lti/delta_system.h"
#include "control/lti/frequency_response.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

namespace halbench::control {
namespace {

using Complex = std::complex<double>;

const TimeBase Base = TimeBase::sampled(0.01);

TEST(DeltaSystem, isTheRationalFunctionOfItsFactor) {
    const auto system = DeltaSystem::factor({2.0, 3.0}, {1.0, 0.5, 0.25}, Base);
    ASSERT_TRUE(system.has_value());
    const Complex d(0.3, -0.7);
    EXPECT_LT(std::abs(system->at(d) - (2.0 * d + 3.0) / (d * d + 0.5 * d + 0.25)), 1e-14);
    EXPECT_NEAR(system->dcGain(), 12.0, 1e-13);
}

// Of d^2 + d + 1e-10 the smaller root is -1e-10 (1 + 1e-10): all its digits, not those that a difference
// leaves.
TEST(DeltaSystem, keepsTheDigitsOfASlowRoot) {
    const auto system = DeltaSystem::factor({1.0}, {1.0, 1.0, 1e-10}, Base);
    const auto& poles = system->poles();
    const Complex slow = std::abs(poles[0]) < std::abs(poles[1]) ? poles[0] : poles[1];
    EXPECT_NEAR(slow.real() / (-1e-10 * (1.0 + 1e-10)), 1.0, 1e-15);
}

TEST(DeltaSystem, hasTheSameValuesFourAtOnce) {
    const auto first = DeltaSystem::factor({0.1, 0.2}, {1.0, 0.1, 0.02}, Base);
    const auto second = DeltaSystem::factor({1.0}, {1.0, 0.0}, Base);
    const auto system = series(*first, *second);
    ASSERT_TRUE(system.has_value());
    EXPECT_TRUE(std::isinf(system->dcGain()));
    const auto frequencies = logarithmicFrequencies(1e-4, 300.0, 23);
    const auto values = system->atFrequencies(frequencies);
    ASSERT_EQ(values.size(), frequencies.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const Complex z = std::polar(1.0, 0.01 * frequencies[i]);
        EXPECT_LT(std::abs(values[i] - system->atFrequency(frequencies[i])), 1e-14 * std::abs(values[i]));
        EXPECT_LT(std::abs(values[i] - system->at(z - 1.0)), 1e-9 * std::abs(values[i])); // z - 1 cancels
    }
}

// exp(1e-9 j) - 1 = 1e-9 j - 5e-19.
TEST(DeltaSystem, hasAllDigitsNearZ1) {
    const Complex d = deltaOf({0.0, 1e-7}, 0.01);
    EXPECT_NEAR(d.real() / -5e-19, 1.0, 1e-14);
    EXPECT_NEAR(d.imag() / 1e-9, 1.0, 1e-14);
    for (const Complex s : {Complex(-3e-4, 2e-3), Complex(-40.0, 200.0), Complex(5.0, -1.0)}) {
        EXPECT_LT(std::abs(rateOf(deltaOf(s, 0.01), 0.01) - s), 1e-13 * std::abs(s));
    }
}

// (d + a)^3 + K = 0: three roots on a circle about -a, also from three equal poles.
TEST(DeltaSystem, closesALoopFromMultiplePoles) {
    const auto loop = DeltaSystem::make({}, {-0.5, -0.5, -0.5}, 2.0, Base);
    for (const double factor : {1e-12, 1e-6, 0.01, 1.0}) {
        const double radius = std::cbrt(2.0 * factor);
        const auto roots = closedLoopRoots(*loop, factor);
        ASSERT_EQ(roots.size(), 3u);
        for (const Complex& root : roots) {
            EXPECT_NEAR(std::abs(root + 0.5) / radius, 1.0, 1e-9) << factor;
        }
        EXPECT_NEAR(std::abs(roots[0] - roots[1]) / radius, std::sqrt(3.0), 1e-8) << factor;
    }
}

// A double integrator with a zero, d^2 + K (d + a): real roots -K/2 +- sqrt(K^2/4 - K a) of any size.
TEST(DeltaSystem, closesALoopOfSlowRoots) {
    for (const double a : {1e-9, 1e-6, 1e-3, 0.1}) {
        const auto loop = DeltaSystem::make({-a}, {0.0, 0.0}, 1.0, Base);
        for (const double K : {5.0 * a, a, 100.0 * a}) {
            const Complex root = std::sqrt(Complex(0.25 * K * K - K * a, 0.0));
            const auto roots = closedLoopRoots(*loop, K);
            for (const Complex& expected : {-0.5 * K - root, -0.5 * K + root}) {
                const double away = std::min(std::abs(roots[0] - expected), std::abs(roots[1] - expected));
                EXPECT_LT(away, 1e-13 * K) << a << " " << K;
            }
            EXPECT_EQ(isStableClosed(*loop, K), std::abs(1.0 - 0.5 * K - root) < 1.0);
        }
    }
}

TEST(DeltaSystem, isStableInsideTheUnitCircle) {
    const auto loop = DeltaSystem::make({}, {0.0}, 1.0, Base); // d = -K, z = 1 - K
    EXPECT_TRUE(isStableClosed(*loop, 1e-12));
    EXPECT_TRUE(isStableClosed(*loop, 1.999));
    EXPECT_FALSE(isStableClosed(*loop, 2.001));
}

TEST(DeltaSystem, isMadeFromRootsInZ) {
    const auto zpk = ZeroPoleGain::make({0.5}, {1.0, 0.25}, 3.0, Base);
    const auto system = toDeltaSystem(*zpk);
    ASSERT_TRUE(system.has_value());
    EXPECT_EQ(poles(*system), zpk->poles());
    EXPECT_EQ(zeros(*system), zpk->zeros());
    EXPECT_LT(std::abs(system->atFrequency(40.0) - zpk->atFrequency(40.0)), 1e-14);
}

TEST(DeltaSystem, refusesWhatIsNone) {
    EXPECT_EQ(DeltaSystem::make({0.0, 0.0}, {0.0}, 1.0, Base).error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(DeltaSystem::make({}, {0.0}, std::nan(""), Base).error().code, ErrorCode::NotFinite);
    EXPECT_EQ(DeltaSystem::factor({1.0}, {0.0}, Base).error().code, ErrorCode::InvalidInput);
    const auto other = DeltaSystem::make({}, {0.0}, 1.0, TimeBase::sampled(0.02));
    EXPECT_EQ(series(*DeltaSystem::make({}, {0.0}, 1.0, Base), *other).error().code, ErrorCode::InvalidInput);
}

TEST(ConjugatePairs, areExactAndLoneOnesReal) {
    const auto paired = inConjugatePairs({{1.0, 1e-17}, {0.5, 0.2}, {0.5 + 1e-16, -0.2 - 1e-16}});
    ASSERT_EQ(paired.size(), 3u);
    EXPECT_EQ(paired[0], Complex(1.0, 0.0));
    EXPECT_EQ(paired[1], std::conj(paired[2]));
}

} // namespace
} // namespace halbench::control
