// Poles of filtered loops: against the roots of one polynomial where that has digits, and by the argument of
// the characteristic function on the unit circle, each factor by itself, where it has none.
#include "control/assess/filtered_loop.h"
#include "control/base/random.h"
#include "control/base/units.h"
#include "control/law/sampled_axis.h"
#include "tests/control/published_motor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

namespace halbench::control {
namespace {

using Complex = std::complex<double>;

/// One point of the unit circle: d = z - 1, d + 2 and z, each to its last digit also at z = 1 and z = -1.
struct OnCircle {
    Complex d;
    Complex dPlus2;
    Complex z;

    explicit OnCircle(double angle_rad)
        : d(Complex(0.0, 2.0 * std::sin(0.5 * angle_rad)) * std::polar(1.0, 0.5 * angle_rad)),
          dPlus2(2.0 * std::cos(0.5 * angle_rad) * std::polar(1.0, 0.5 * angle_rad)),
          z(std::polar(1.0, angle_rad)) {}
};

Complex filterFactor(const Polynomial& polynomial, int order, double rate_1_s, const OnCircle& at) {
    Complex sum = 0.0;
    const int highest = degree(polynomial);
    for (int power = 0; power <= highest; ++power) {
        sum += polynomial[static_cast<std::size_t>(highest - power)] * std::pow(rate_1_s * at.d, power) *
               std::pow(at.dPlus2, order - power);
    }
    return sum;
}

/// D + N of the open loop as products.
Complex characteristic(const PositionPlant& plant, const FilteredLaw& law, const LoopTiming& timing,
                       double angle_rad) {
    const OnCircle at(angle_rad);
    const double T = timing.period_s;
    const PidGains gains = *checkedGains(law, T);
    const double span_s = T + gains.filter_s.value_or(0.0);
    const bool hasIntegral = gains.integral != 0.0;
    const bool hasDerivative = gains.derivative != 0.0;
    const Complex slow = hasIntegral ? at.d : Complex(1.0);
    const Complex fast = hasDerivative ? at.d + T / span_s : Complex(1.0);
    Complex N = gains.proportional * slow * fast + (hasIntegral ? T * gains.integral * fast : Complex(0.0)) +
                (hasDerivative ? gains.derivative / span_s * at.d * slow : Complex(0.0));
    Complex D = slow * fast * std::pow(at.z, timing.delay_samples);
    for (const LoopFilter& filter : law.filters) {
        const auto continuous = continuousFilter(filter);
        const double w = frequencyOf_rad_s(filter);
        const double rate_1_s = w / std::tan(0.5 * w * T);
        N *= filterFactor(continuous->numerator(), continuous->order(), rate_1_s, at);
        D *= filterFactor(continuous->denominator(), continuous->order(), rate_1_s, at);
    }
    const double x = plant.dampingRate_1_s * T;
    N *= plant.accelerationGain_rad_s2_A * T * T * (heldAngleShare(x) * at.d + heldSpeedShare(x));
    D *= at.d * (at.d - std::expm1(-x));
    return D + N;
}

/// Poles within the unit circle: the argument of a real polynomial turns by pi for each on the upper half.
template <typename Function>
int insideCount(Function value, std::vector<double> angles_rad) {
    angles_rad.push_back(0.0);
    angles_rad.push_back(Pi);
    std::sort(angles_rad.begin(), angles_rad.end());
    double turned_rad = 0.0;
    for (std::size_t i = 1; i < angles_rad.size(); ++i) {
        std::vector<std::pair<double, Complex>> ends = {{angles_rad[i], value(angles_rad[i])}};
        double from_rad = angles_rad[i - 1];
        Complex from = value(from_rad);
        while (!ends.empty()) {
            const auto [to_rad, to] = ends.back();
            const double turn_rad = std::arg(to / from);
            if (std::abs(turn_rad) > 0.3 && ends.size() < 60) {
                const double middle_rad = 0.5 * (from_rad + to_rad);
                ends.emplace_back(middle_rad, value(middle_rad));
            } else {
                turned_rad += turn_rad;
                from_rad = to_rad;
                from = to;
                ends.pop_back();
            }
        }
    }
    return static_cast<int>(std::lround(turned_rad / Pi));
}

double between(Random& random, double low, double high) {
    return low * std::pow(high / low, random.uniform());
}

PidGains randomGains(Random& random) {
    PidGains gains;
    gains.proportional = between(random, 1.0, 40.0);
    gains.integral = random.below(3) == 0 ? 0.0 : between(random, 0.5, 60.0);
    gains.derivative = random.below(5) == 0 ? 0.0 : between(random, 0.1, 1.5);
    if (random.below(2) == 0) {
        gains.filter_s = between(random, 1e-3, 0.03);
    }
    return gains;
}

LoopFilter mildFilter(Random& random) {
    const double w = between(random, 20.0, 250.0);
    switch (random.below(4)) {
    case 0:
        return LeadFilter{w, 10.0 + 50.0 * random.uniform()};
    case 1:
        return LagFilter{w, 2.0 + 8.0 * random.uniform()};
    case 2:
        return NotchFilter{w, random.uniform(), 0.2 + random.uniform()};
    default:
        return LowPassFilter{w, 1 + static_cast<int>(random.below(2))};
    }
}

/// As slow, as narrow and as near to Nyquist (314 rad/s) as the checks let pass.
LoopFilter extremeFilter(Random& random) {
    switch (random.below(4)) {
    case 0:
        return LagFilter{between(random, 2e-3, 1.0), between(random, 2.0, 10.0)};
    case 1:
        return NotchFilter{between(random, 290.0, 313.0), 0.1 * random.uniform(), between(random, 1e-3, 0.1)};
    case 2:
        return NotchFilter{between(random, 1e-3, 1.0), random.uniform(), between(random, 0.01, 1.0)};
    default:
        return LowPassFilter{between(random, 100.0, 312.0), 2};
    }
}

double farthest(std::vector<Complex> one, const std::vector<Complex>& other) {
    double farthest = one.size() == other.size() ? 0.0 : HUGE_VAL;
    for (const Complex& pole : other) {
        const auto nearest = std::min_element(one.begin(), one.end(), [&](Complex a, Complex b) {
            return std::abs(a - pole) < std::abs(b - pole);
        });
        if (nearest != one.end()) {
            farthest = std::max(farthest, std::abs(*nearest - pole));
            one.erase(nearest);
        }
    }
    return farthest;
}

// Of one filter that is not slow the polynomial of order 6 to 8 keeps its roots to the root of its rounding.
TEST(FilteredPoles, areTheRootsOfThePolynomialWhereThatHasDigits) {
    Random random(61);
    for (int round = 0; round < 200; ++round) {
        FilteredLaw law;
        law.gains = randomGains(random);
        law.filters = {mildFilter(random)};
        const LoopTiming timing{0.01, static_cast<int>(random.below(3))};
        const auto poles = filteredPoles(published(), law, timing);
        const auto loop = filteredOpenLoop(published(), law, timing);
        ASSERT_TRUE(poles && loop) << round;
        EXPECT_LT(farthest(*poles, closedLoopPoles(*loop)), 1e-5) << round;
        const auto radius = filteredPoleRadius(published(), law, timing);
        EXPECT_NEAR(*radius, poleRadius(*loop), 1e-6) << round;
    }
}

TEST(FilteredPoles, ofALawWithoutFiltersAreThoseOfThePolynomialToTheLastBit) {
    FilteredLaw law;
    law.gains = recommended();
    const LoopTiming timing{0.01, 1};
    EXPECT_EQ(*filteredPoles(published(), law, timing),
              closedLoopPoles(*filteredOpenLoop(published(), law, timing)));
    EXPECT_EQ(*filteredPoleRadius(published(), law, timing),
              poleRadius(*filteredOpenLoop(published(), law, timing)));
}

TEST(FilteredPoles, ofManyProportionalGainsAreThoseOfEach) {
    Random random(7);
    const LoopTiming timing{0.01, 1};
    FilteredLaw law;
    law.gains = randomGains(random);
    for (const bool isFiltered : {false, true}) {
        if (isFiltered) {
            law.filters = {extremeFilter(random), extremeFilter(random)};
        }
        const auto radius = filteredPoleRadiusOfProportional(published(), law, timing);
        ASSERT_TRUE(radius) << radius.error().message;
        for (const double proportional : {0.3, 4.0, 90.0}) {
            FilteredLaw one = law;
            one.gains.proportional = proportional;
            EXPECT_EQ(*(*radius)(proportional), *filteredPoleRadius(published(), one, timing)) << isFiltered;
        }
    }
    law.filters.assign(5, law.filters.front());
    EXPECT_FALSE(filteredPoleRadiusOfProportional(published(), law, timing));
}

// The count of poles within the circle decides, four extreme filters at once; one polynomial calls some of
// these loops unstable.
TEST(FilteredPolesSeeds, ofFourExtremeFiltersAtOnceTellStability) {
    Random random(62);
    int stable = 0;
    int mended = 0;
    for (int round = 0; round < 80; ++round) {
        FilteredLaw law;
        law.gains = randomGains(random);
        while (law.filters.size() < 4) {
            law.filters.push_back(extremeFilter(random));
        }
        const LoopTiming timing{0.01, static_cast<int>(random.below(2))};
        const auto poles = filteredPoles(published(), law, timing);
        const auto loop = filteredOpenLoop(published(), law, timing);
        ASSERT_TRUE(poles && loop) << round;
        std::vector<double> angles_rad;
        for (int i = 0; i <= 4000; ++i) {
            angles_rad.push_back(Pi * std::pow(10.0, -10.0 * i / 4000.0));
        }
        for (const Complex& pole : *poles) { // close around each, so that none is overlooked
            const double at_rad = std::abs(std::arg(pole));
            const double away = std::max(std::abs(std::abs(pole) - 1.0), 1e-12);
            for (int i = -40; i <= 40; ++i) {
                angles_rad.push_back(std::clamp(at_rad + 0.25 * i * away, 0.0, Pi));
            }
        }
        const auto value = [&](double angle_rad) {
            return characteristic(published(), law, timing, angle_rad);
        };
        const int inside = insideCount(value, angles_rad);
        const auto found = std::count_if(poles->begin(), poles->end(),
                                         [](const Complex& pole) { return std::abs(pole) < 1.0; });
        EXPECT_EQ(found, inside) << round;
        const bool isStable = inside == static_cast<int>(poles->size());
        stable += isStable ? 1 : 0;
        mended += isStable && poleRadius(*loop) >= 1.0 ? 1 : 0;
    }
    EXPECT_GT(stable, 20);
    EXPECT_GT(mended, 0);
}

} // namespace
} // namespace halbench::control
