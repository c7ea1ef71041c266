// Margins, frequency responses and loci of filtered loops against two other routes: the textbook forms of
// each part in 64 bits of mantissa, and values of 50 digits. The latter were made by mpmath 1.3 from the
// same formulas as `Route` (rotor by partial fractions, filters at s = w0/tan(w0 T/2) (z - 1)/(z + 1)), each
// crossing narrowed down from 400 points a decade, Ms by golden section; in c/J = 1.23e-3/5.5e-4, phi/J =
// 1.43e-2/5.5e-4, T = 0.01 s.
#include "control/analysis/loop_functions.h"
#include "control/analysis/margins.h"
#include "control/analysis/nyquist.h"
#include "control/analysis/root_locus.h"
#include "control/assess/filtered_loop.h"
#include "control/base/random.h"
#include "control/base/units.h"
#include "control/law/filtered_delta.h"
#include "tests/control/filtered_example.h"
#include "tests/control/published_motor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

namespace halbench::control {
namespace {

using Long = std::complex<long double>;
constexpr long double LongPi = 3.14159265358979323846264338327950288L;

struct Case {
    FilteredLaw law;
    LoopTiming timing;
};

/// L at a point of the unit circle, each part by its textbook form.
class Route {
public:
    explicit Route(const Case& given) : m_case(given), m_plant(published()) {}

    Long at(long double w) const {
        const long double T = m_case.timing.period_s;
        const long double half = 0.5L * w * T;
        // z - 1 to its last digit, and (z - 1)/(z + 1) = j tan(w T/2).
        const Long d = Long(0.0L, 2.0L * std::sin(half)) * std::polar(1.0L, half);
        const Long z = std::polar(1.0L, w * T);
        const PidGains& gains = m_case.law.gains;
        const long double filter_s = gains.filter_s.value_or(0.0);
        Long value = Long(gains.proportional) + Long(gains.integral * T) / d +
                     Long(gains.derivative) * d / (Long(T) + (T + filter_s) * d);
        const long double a = m_plant.dampingRate_1_s;
        const long double fall = std::expm1(-a * T); // E - 1
        value *= Long(m_plant.accelerationGain_rad_s2_A / a) * (T / d + fall / (a * (d - fall)));
        for (int i = 0; i < m_case.timing.delay_samples; ++i) {
            value /= z;
        }
        for (const LoopFilter& filter : m_case.law.filters) {
            const long double w0 = frequencyOf_rad_s(filter);
            value *= filterAt(filter, Long(0.0L, w0 / std::tan(0.5L * w0 * T) * std::tan(half)));
        }
        return value;
    }

    /// 250 points a decade, and 80 about each notch.
    std::vector<long double> grid() const {
        const long double nyquist = LongPi / m_case.timing.period_s;
        std::vector<long double> grid;
        for (int i = -1500; i < 625; ++i) {
            grid.push_back(std::pow(10.0L, static_cast<long double>(i) / 250.0L));
        }
        for (const LoopFilter& filter : m_case.law.filters) {
            if (const auto* notch = std::get_if<NotchFilter>(&filter)) {
                for (int i = -40; i <= 40; ++i) {
                    grid.push_back(notch->frequency_rad_s * (1.0L + 0.02L * static_cast<long double>(i) *
                                                                        std::min(1.0, notch->damping_ratio)));
                }
            }
        }
        std::erase_if(grid, [&](long double w) { return w >= nyquist; });
        std::sort(grid.begin(), grid.end());
        return grid;
    }

private:
    static Long filterAt(const LoopFilter& filter, Long s) {
        if (const auto* f = std::get_if<LeadFilter>(&filter)) {
            const long double sine = std::sin(f->phase_deg * LongPi / 180.0L);
            const long double r = std::sqrt((1.0L + sine) / (1.0L - sine));
            const long double w = f->frequency_rad_s;
            return (Long(1.0L) + r * s / w) / (Long(1.0L) + s / (r * w)) / r;
        }
        if (const auto* f = std::get_if<LagFilter>(&filter)) {
            const long double w = f->frequency_rad_s;
            return (s + w) / (s + w / f->ratio);
        }
        if (const auto* f = std::get_if<NotchFilter>(&filter)) {
            const long double w = f->frequency_rad_s;
            const Long middle = 2.0L * f->damping_ratio * w * s;
            return (s * s + static_cast<long double>(f->depth_ratio) * middle + w * w) /
                   (s * s + middle + w * w);
        }
        const auto& f = std::get<LowPassFilter>(filter);
        const long double w = f.corner_rad_s;
        return f.order == 1 ? Long(w) / (s + w) : Long(w * w) / (s * s + std::sqrt(2.0L) * w * s + w * w);
    }

    Case m_case;
    PositionPlant m_plant;
};

template <typename Function>
long double bisected(Function function, long double low, long double high) {
    const bool isNegative = function(low) < 0.0L;
    for (int i = 0; i < 80; ++i) {
        const long double middle = 0.5L * (low + high);
        ((function(middle) < 0.0L) == isNegative ? low : high) = middle;
    }
    return 0.5L * (low + high);
}

/// Gain crossings, and phase crossings with |L| above a millionth.
std::vector<Crossing> crossingsOn(const Route& route) {
    const auto grid = route.grid();
    std::vector<Crossing> found;
    Long before = route.at(grid.front());
    for (std::size_t i = 1; i < grid.size(); ++i) {
        const Long here = route.at(grid[i]);
        if ((std::norm(before) < 1.0L) != (std::norm(here) < 1.0L)) {
            const long double w =
                bisected([&](long double x) { return std::norm(route.at(x)) - 1.0L; }, grid[i - 1], grid[i]);
            const auto margin = static_cast<double>(std::arg(-route.at(w)) * 180.0L / LongPi);
            found.push_back({Crossing::Kind::Gain, static_cast<double>(w), margin, 0.0, 1.0});
        }
        if ((before.imag() < 0.0L) != (here.imag() < 0.0L) && here.real() < -1e-6L) {
            const long double w =
                bisected([&](long double x) { return route.at(x).imag(); }, grid[i - 1], grid[i]);
            found.push_back({Crossing::Kind::Phase, static_cast<double>(w), 0.0, 0.0,
                             static_cast<double>(1.0L / std::abs(route.at(w)))});
        }
        before = here;
    }
    return found;
}

long double largestSensitivity(const Route& route) {
    const auto grid = route.grid();
    const auto away = [&](long double w) { return std::abs(Long(1.0L) + route.at(w)); };
    std::size_t best = 0;
    for (std::size_t i = 1; i < grid.size(); ++i) {
        best = away(grid[i]) < away(grid[best]) ? i : best;
    }
    long double low = grid[best == 0 ? 0 : best - 1];
    long double high = grid[std::min(best + 1, grid.size() - 1)];
    for (int i = 0; i < 60; ++i) { // thirds: one minimum between neighbours of the best point
        const long double left = low + (high - low) / 3.0L;
        const long double right = high - (high - low) / 3.0L;
        (away(left) < away(right) ? high : low) = away(left) < away(right) ? right : left;
    }
    return 1.0L / away(0.5L * (low + high));
}

double between(Random& random, double low, double high) {
    return low * std::pow(high / low, random.uniform());
}

LoopFilter slowFilter(Random& random) {
    const double w = between(random, 0.01, 20.0);
    switch (random.below(4)) {
    case 0:
        return LeadFilter{w, 10.0 + 50.0 * random.uniform()};
    case 1:
        return LagFilter{w, 2.0 + 8.0 * random.uniform()};
    case 2:
        return NotchFilter{w, random.uniform(), 0.05 + random.uniform()};
    default:
        return LowPassFilter{w, 1 + static_cast<int>(random.below(2))};
    }
}

Case randomCase(Random& random) {
    Case drawn;
    drawn.timing = {0.01, static_cast<int>(random.below(3))};
    PidGains& gains = drawn.law.gains;
    gains.proportional = between(random, 1e-3, 10.0);
    gains.integral = random.below(2) == 0 ? 0.0 : gains.proportional * between(random, 1e-3, 1.0);
    gains.derivative = random.below(2) == 0 ? 0.0 : gains.proportional * between(random, 0.01, 1.0);
    if (random.below(2) == 0) {
        gains.filter_s = between(random, 1e-3, 0.03);
    }
    for (std::uint64_t i = 0; i < 1 + random.below(4); ++i) {
        drawn.law.filters.push_back(slowFilter(random));
    }
    drawn.law.filters.resize(std::min<std::size_t>(drawn.law.filters.size(), 4));
    return drawn;
}

PidGains proportional(double kp) {
    PidGains gains;
    gains.proportional = kp;
    return gains;
}

FilteredLaw law(const PidGains& gains, std::vector<LoopFilter> filters) {
    FilteredLaw result = of(gains);
    result.filters = std::move(filters);
    return result;
}

const double W02 = 2.0 * Pi * 0.02;
const double W05 = 2.0 * Pi * 0.05;

// 1 + L to 12 digits: nothing of double precision is left out of the tolerance but a few roundings of each
// of a dozen factors, 1e-14, divided by the slope of the curve at its crossing, below 100 here.
TEST(FilteredDelta, hasTheMarginsOf50DigitsWhereCoefficientsOfZHaveNone) {
    struct Known {
        Case given;
        double crossover_rad_s, phaseMargin_deg, Ms_ratio;
    };
    PidGains four = proportional(0.05);
    four.integral = 0.0005;
    four.derivative = 0.4;
    four.filter_s = 0.02;
    PidGains pi = proportional(0.02);
    pi.integral = 0.0001;
    PidGains pd = proportional(2.0);
    pd.derivative = 0.3;
    const std::vector<Known> all = {
        {{law(proportional(0.025), {LowPassFilter{W02, 1}, LowPassFilter{W05, 1}}), {0.01, 0}},
         0.159762174765,
         7.10039904507,
         9.35907049711},
        {{law(proportional(0.006), {LowPassFilter{W02, 2}, LowPassFilter{W05, 2}}), {0.01, 0}},
         0.0669985742011,
         24.2388257988,
         3.97167353878},
        {{law(pi, {LagFilter{0.01, 8.0}, LagFilter{0.004, 5.0}, LowPassFilter{0.5, 2}}), {0.01, 1}},
         0.226879733002,
         40.791995368,
         2.21592275675},
        {{law(four, {NotchFilter{0.3, 0.1, 0.2}, LagFilter{0.02, 6.0}, LowPassFilter{0.8, 1},
                     LeadFilter{1.5, 50.0}}),
          {0.01, 2}},
         3.51120110038,
         75.4808607808,
         1.44153903536},
        {{law(proportional(0.003), {LowPassFilter{0.05, 2}, LowPassFilter{0.06, 2}, LowPassFilter{0.4, 2},
                                    LowPassFilter{0.02, 1}}),
          {0.01, 0}},
         0.022492971286,
         -33.7463907506,
         2.22027424558},
        {{law(pd, {LagFilter{0.002, 10.0}, LagFilter{0.003, 10.0}, LagFilter{0.005, 10.0},
                   LowPassFilter{60.0, 2}}),
          {0.01, 1}},
         9.4776302196,
         45.6196986194,
         1.53816727112}};
    for (const Known& known : all) {
        const auto loop = deltaOpenLoop(published(), known.given.law, known.given.timing);
        ASSERT_TRUE(loop.has_value());
        const StabilityMargins margins = smallestMargins(*loop);
        ASSERT_TRUE(margins.gainCrossover_rad_s.has_value());
        EXPECT_NEAR(*margins.gainCrossover_rad_s / known.crossover_rad_s, 1.0, 1e-11);
        EXPECT_NEAR(margins.phaseMargin_deg, known.phaseMargin_deg, 1e-9);
        EXPECT_NEAR(sensitivityPeaks(*loop).Ms_ratio / known.Ms_ratio, 1.0, 1e-10);
        EXPECT_FALSE(margins.knownFrom_rad_s.has_value());
    }
}

TEST(FilteredDeltaSeeds, has300RandomLoopsWithTheCrossingsOfAnotherRoute) {
    Random random(7);
    for (int i = 0; i < 300; ++i) {
        const Case drawn = randomCase(random);
        const auto loop = deltaOpenLoop(published(), drawn.law, drawn.timing);
        ASSERT_TRUE(loop.has_value()) << i;
        const Route route(drawn);
        std::vector<Crossing> found = allCrossings(*loop);
        std::erase_if(found, [](const Crossing& c) { // the route's ends
            return c.frequency_rad_s < 1.001e-6 || c.frequency_rad_s > 313.9 || c.gainMargin_ratio > 0.99e6;
        });
        std::vector<Crossing> expected = crossingsOn(route);
        std::erase_if(expected, [](const Crossing& c) { return c.gainMargin_ratio > 0.99e6; });
        ASSERT_EQ(found.size(), expected.size()) << i;
        for (std::size_t n = 0; n < found.size(); ++n) {
            // A dozen factors of 1e-15, magnified where the curve runs almost along what it crosses.
            EXPECT_EQ(found[n].kind, expected[n].kind) << i;
            EXPECT_NEAR(found[n].frequency_rad_s / expected[n].frequency_rad_s, 1.0, 1e-9) << i;
            EXPECT_NEAR(found[n].phaseMargin_deg, expected[n].phaseMargin_deg, 1e-7) << i;
            EXPECT_NEAR(found[n].gainMargin_ratio / expected[n].gainMargin_ratio, 1.0, 1e-9) << i;
        }
        const auto Ms = static_cast<double>(largestSensitivity(route));
        EXPECT_NEAR(sensitivityPeaks(*loop).Ms_ratio / std::max(Ms, 1.0), 1.0, 1e-8) << i;
    }
}

TEST(FilteredDelta, hasTheFrequencyResponseOfAnotherRouteDownToAMicrohertz) {
    Random random(8);
    for (int i = 0; i < 100; ++i) {
        const Case drawn = randomCase(random);
        const auto loop = deltaOpenLoop(published(), drawn.law, drawn.timing);
        const auto controller = deltaController(drawn.law, drawn.timing.period_s);
        ASSERT_TRUE(loop.has_value() && controller.has_value()) << i;
        std::vector<double> frequency_rad_s;
        for (double w = 1e-5; w < 310.0; w *= 1.7) {
            frequency_rad_s.push_back(w);
        }
        const auto values = loop->atFrequencies(frequency_rad_s);
        for (std::size_t n = 0; n < values.size(); ++n) {
            const Long expected = Route(drawn).at(frequency_rad_s[n]);
            const auto error = std::abs(Long(values[n]) - expected) / std::abs(expected);
            EXPECT_LT(static_cast<double>(error), 1e-12) << i << " at " << frequency_rad_s[n];
            EXPECT_LT(std::abs(values[n] - loop->atFrequency(frequency_rad_s[n])),
                      1e-14 * std::abs(values[n]));
        }
    }
}

// One polynomial has no digits there and says so; the board's own law, a loop without filters, is the same.
TEST(FilteredDelta, agreesWithCoefficientsOfZWhereTheseHaveDigits) {
    for (const int delay : {0, 1, 2}) {
        const LoopTiming timing{0.01, delay};
        const auto roots = deltaOpenLoop(published(), filtered(), timing);
        const auto polynomial = filteredOpenLoop(published(), filtered(), timing);
        const StabilityMargins one = smallestMargins(*roots);
        const StabilityMargins other = smallestMargins(*polynomial);
        EXPECT_NEAR(one.phaseMargin_deg, other.phaseMargin_deg, 1e-8);
        EXPECT_NEAR(one.gainMargin_ratio, other.gainMargin_ratio, 1e-8);
        EXPECT_NEAR(one.delayMargin_s, other.delayMargin_s, 1e-10);
        const auto closed = feedback(*polynomial, TransferFunction::gain(1.0, polynomial->timeBase()));
        EXPECT_NEAR(*closedBandwidth_rad_s(*roots) / *bandwidth_rad_s(*closed), 1.0, 1e-8);
        EXPECT_EQ(nyquist(*roots)->encirclements, nyquist(*polynomial)->encirclements);
    }
    const auto slow = filteredOpenLoop(
        published(), law(proportional(0.006), {LowPassFilter{W02, 2}, LowPassFilter{W05, 2}}), NoDelay);
    EXPECT_TRUE(smallestMargins(*slow).knownFrom_rad_s.has_value());
}

// By the argument principle on the unit circle against the poles from states.
TEST(FilteredDelta, isCountedByNyquistAsItsPolesAre) {
    Random random(9);
    for (int i = 0; i < 100; ++i) {
        const Case drawn = randomCase(random);
        const auto loop = deltaOpenLoop(published(), drawn.law, drawn.timing);
        const auto poles = filteredPoles(published(), drawn.law, drawn.timing);
        ASSERT_TRUE(loop.has_value() && poles.has_value());
        const auto outside = std::count_if(poles->begin(), poles->end(),
                                           [](const auto& pole) { return std::abs(pole) > 1.0; });
        const auto counted = nyquist(*loop);
        ASSERT_TRUE(counted.has_value()) << i;
        EXPECT_EQ(counted->unstableClosedLoopPoles, outside) << i;
    }
}

/// The largest distance, in d, of a closed pole from the nearest of the other list, as a share of its size.
double apart_ratio(const std::vector<std::complex<double>>& ones,
                   const std::vector<std::complex<double>>& others) {
    double most = 0.0;
    for (const auto& one : ones) {
        double least = HUGE_VAL;
        for (const auto& other : others) {
            least = std::min(least, std::abs(one - other) / (std::abs(one - 1.0) + 1e-6));
        }
        most = std::max(most, least);
    }
    return most;
}

TEST(FilteredDelta, hasBoundedLociThatEndAtThePolesOfStates) {
    Random random(10);
    std::size_t most = 0;
    for (int i = 0; i < 200; ++i) {
        const Case drawn = randomCase(random);
        const auto loop = deltaOpenLoop(published(), drawn.law, drawn.timing);
        const auto locus = rootLocus(*loop, 4.0);
        ASSERT_TRUE(locus.has_value()) << i;
        EXPECT_EQ(locus->gain.back(), 4.0) << i;
        most = std::max(most, locus->gain.size());
        FilteredLaw louder = drawn.law;
        louder.gains.proportional *= 4.0;
        louder.gains.integral *= 4.0;
        louder.gains.derivative *= 4.0;
        const auto expected = filteredPoles(published(), louder, drawn.timing);
        std::vector<std::complex<double>> ends;
        for (const auto& branch : locus->branch) {
            ends.push_back(branch.back());
            for (std::size_t n = 1; n < branch.size(); ++n) { // no branch jumps to another
                ASSERT_LT(std::abs(branch[n] - branch[n - 1]), 0.05) << i;
            }
        }
        // Poles of states keep 1e-16 of the matrix, of a pair that lies together the root of it.
        EXPECT_LT(apart_ratio(ends, *expected), 1e-4) << i;
        EXPECT_LT(apart_ratio(*expected, ends), 1e-4) << i;
    }
    EXPECT_LT(most, 1000u); // a step is a hundredth of the picture, or a third of the way to a neighbour
}

TEST(FilteredDelta, saysBetweenWhichGainsALoopIsStable) {
    // K_P = 0.025 with a gain margin of 1.27061140205, of 50 digits.
    const auto low = deltaOpenLoop(
        published(), law(proportional(0.025), {LowPassFilter{W02, 1}, LowPassFilter{W05, 1}}), NoDelay);
    const auto below = stableGains(*low, allCrossings(*low));
    ASSERT_TRUE(below.has_value());
    EXPECT_EQ(below->from_ratio, 0.0);
    EXPECT_NEAR(below->to_ratio, 1.27061140205, 1e-9);

    // The same loop at 100 times the gain: the limit lies below.
    const auto loud = deltaOpenLoop(
        published(), law(proportional(2.5), {LowPassFilter{W02, 1}, LowPassFilter{W05, 1}}), NoDelay);
    const auto crossings = allCrossings(*loud);
    const auto lower = stableGains(*loud, crossings);
    ASSERT_TRUE(lower.has_value());
    EXPECT_NEAR(lower->to_ratio, 0.0127061140205, 1e-11);
    const StabilityMargins lowered = withStableGains(smallestMargins(*loud), crossings, lower);
    EXPECT_NEAR(lowered.gainMargin_ratio, 0.0127061140205, 1e-11);
    EXPECT_EQ(lowered.delayMargin_s, 0.0);
    EXPECT_GT(withStableGains(smallestMargins(*low), allCrossings(*low), below).delayMargin_s, 0.0);

    // PI with K_I/K_P = 8 1/s above c/J = 2.24 1/s: by Routh's criterion no gain of the continuous loop is
    // stable, and holding and sampling only add delay.
    PidGains fast = proportional(1.0);
    fast.integral = 8.0;
    const auto never = deltaOpenLoop(published(), of(fast), {0.01, 1});
    const auto others = allCrossings(*never);
    EXPECT_FALSE(stableGains(*never, others).has_value());
    const StabilityMargins none = withStableGains(smallestMargins(*never), others, std::nullopt);
    EXPECT_TRUE(std::isinf(none.gainMargin_ratio));
    EXPECT_FALSE(none.phaseCrossover_rad_s.has_value());
    EXPECT_EQ(none.delayMargin_s, 0.0) << "an unstable loop bears no delay";

    // With derivative action that integral needs gain: the limit lies above.
    PidGains weak = proportional(0.02);
    weak.integral = 0.2;
    weak.derivative = 0.01;
    const auto raised = deltaOpenLoop(published(), of(weak), NoDelay);
    const auto above = stableGains(*raised, allCrossings(*raised));
    ASSERT_TRUE(above.has_value());
    EXPECT_GT(above->from_ratio, 1.0);
    // Between the ends it is stable, a little beyond either it is not.
    for (const auto& [factor, isInside] :
         {std::pair(1.001 * above->from_ratio, true), std::pair(0.999 * above->from_ratio, false),
          std::pair(0.999 * above->to_ratio, true), std::pair(1.001 * above->to_ratio, false)}) {
        EXPECT_EQ(isStableClosed(*raised, factor), isInside) << factor;
        PidGains scaled = weak;
        scaled.proportional *= factor;
        scaled.integral *= factor;
        scaled.derivative *= factor;
        EXPECT_EQ(poleRadius(*sampledOpenLoop(published(), scaled, NoDelay)) < 1.0, isInside) << factor;
    }
}

TEST(FilteredDelta, refusesWhatItsPartsRefuse) {
    EXPECT_EQ(deltaOpenLoop({1.0, 0.0, 0.0}, filtered(), NoDelay).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(deltaOpenLoop(published(), filtered(), {0.01, -1}).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(deltaController(law(proportional(1.0), {LowPassFilter{-1.0, 1}}), 0.01).error().code,
              ErrorCode::OutOfRange);
    EXPECT_EQ(filterGainAtRest({LagFilter{1.0, 0.5}}).error().code, ErrorCode::OutOfRange);
}

// Lag 8, lead 1/sqrt(r) with r = (1 + 1/2)/(1 - 1/2) = 3, the others 1.
TEST(FilteredDelta, hasTheGainOfItsFiltersAtRest) {
    EXPECT_NEAR(*filterGainAtRest({LagFilter{0.001, 8.0}, LeadFilter{3.0, 30.0}, NotchFilter{2.0, 0.1, 0.2},
                                   LowPassFilter{0.001, 2}}),
                8.0 / std::sqrt(3.0), 1e-14);
}

} // namespace
} // namespace halbench::control
