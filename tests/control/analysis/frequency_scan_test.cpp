#include "control/analysis/frequency_scan.h"
#include "control/base/units.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

TransferFunction make(Polynomial numerator, Polynomial denominator, TimeBase base) {
    return *TransferFunction::make(std::move(numerator), std::move(denominator), base);
}

TEST(FrequencyScan, ascendsFromBelowTheSlowestToAboveTheFastestPole) {
    const auto frequencies =
        scanFrequencies(make({1.0}, fromRoots({{-0.2, 0.0}, {-3e3, 0.0}}), TimeBase::continuous()));
    EXPECT_TRUE(std::is_sorted(frequencies.begin(), frequencies.end()));
    EXPECT_LE(frequencies.front(), 0.002 * (1.0 + 1e-12));
    EXPECT_GE(frequencies.back(), 3e5 * (1.0 - 1e-12));
}

TEST(FrequencyScan, ofASampledSystemEndsAtTheNyquistFrequency) {
    const auto frequencies = scanFrequencies(make({0.1}, {1.0, -0.9}, TimeBase::sampled(0.02)));
    EXPECT_DOUBLE_EQ(frequencies.back(), Pi / 0.02);
}

TEST(FrequencyScan, looksCloserAroundAResonance) {
    const double w = 40.0;
    const double zeta = 1e-3;
    const auto frequencies =
        scanFrequencies(make({1.0}, {1.0, 2.0 * zeta * w, w * w}, TimeBase::continuous()));
    const auto near = std::count_if(frequencies.begin(), frequencies.end(),
                                    [&](double f) { return std::abs(f - w) < 2.0 * zeta * w; });
    EXPECT_GE(near, 10);
}

// Two integrators and a slow pole at z = 1: below about 1e-3 rad/s the denominator is rounding.
TEST(FrequencyScan, leavesOutFrequenciesWhereTheDenominatorHasNoDigits) {
    const auto loop =
        make({1e-3, -0.999e-3}, fromRoots({{1.0, 0.0}, {1.0, 0.0}, {0.98, 0.0}}), TimeBase::sampled(0.01));
    for (const double frequency : scanFrequencies(loop)) {
        const std::complex<double> z = std::polar(1.0, frequency * 0.01);
        const std::complex<double> exact = (z - 1.0) * (z - 1.0) * (z - 0.98);
        // Three digits are what the scan asks of a denominator that cancels.
        ASSERT_LT(std::abs(evaluate(loop.denominator(), z) - exact), 1e-3 * std::abs(exact)) << frequency;
    }
}

/// The zero, and how many values were asked for.
struct Found {
    double x = 0.0;
    int values = 0;
};

template <typename Function>
Found countedRoot(Function function, double low, double high) {
    Found found;
    found.x = rootBetween(
        [&](double x) {
            ++found.values;
            return function(x);
        },
        low, high);
    return found;
}

// Tolerance: the rounding of x, from either side.
TEST(FrequencyScan, findsAZeroToTheRounding) {
    EXPECT_NEAR(rootBetween([](double x) { return x * x - 2.0; }, 1.0, 2.0), std::sqrt(2.0), 1e-15);
    EXPECT_NEAR(rootBetween([](double x) { return 2.0 - x * x; }, 1.0, 2.0), std::sqrt(2.0), 1e-15);
    EXPECT_NEAR(rootBetween([](double x) { return std::log(x); }, 1e-6, 1e6), 1.0, 1e-15);
    EXPECT_EQ(rootBetween([](double x) { return x - 3.0; }, 3.0, 4.0), 3.0);
}

TEST(FrequencyScan, aZeroOfASmoothFunctionTakesFewValues) {
    const Found cosine = countedRoot([](double x) { return std::cos(x) - x; }, 0.7, 0.8);
    EXPECT_NEAR(cosine.x, 0.7390851332151607, 3e-16); // the Dottie number; its rounding is 1e-16
    EXPECT_LE(cosine.values, 10);
}

// A halving takes 53 rounds for any function; what is flat or jumps may not cost a multiple of it.
TEST(FrequencyScan, aJumpAndAFlatZeroAreFoundTooInTheEnd) {
    const Found jump = countedRoot([](double x) { return x < 1.7 ? -1.0 : 1e9; }, 1.0, 2.0);
    EXPECT_NEAR(jump.x, 1.7, 1e-15);
    EXPECT_LE(jump.values, 120);
    const Found flat = countedRoot([](double x) { return std::pow(x - 1.3, 9); }, 1.0, 2.0);
    EXPECT_NEAR(flat.x, 1.3, 1e-15); // the ninth power has its digits: only x is rounded
    EXPECT_LE(flat.values, 200);
}

TEST(FrequencyScan, aFunctionWithoutValueInsideIsHalved) {
    const auto holed = [](double x) { return x < 1.5 ? -1.0 : (x < 1.75 ? NAN : 1.0); };
    const double x = rootBetween(holed, 1.0, 2.0);
    EXPECT_GE(x, 1.5 - 1e-15);
    EXPECT_LE(x, 1.75);
}

TEST(FrequencyScan, findsTheSmallestValueBetweenThePoints) {
    const auto bowl = [](double x) { return (x - 1.234) * (x - 1.234) + 1.0; };
    // A minimum is known to the square root of the rounding.
    EXPECT_NEAR(goldenMinimum(bowl, 0.0, 3.0), 1.234, 1e-7);
    EXPECT_NEAR(scanMinimum(bowl, {0.0, 1.0, 2.0, 3.0}), 1.234, 1e-7);
    EXPECT_EQ(scanMinimum([](double x) { return x; }, {2.0, 3.0, 4.0}), 2.0);
}

} // namespace
} // namespace halbench::control
