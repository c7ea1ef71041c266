#include "control/analysis/describing_function.h"
#include "control/analysis/margins.h"
#include "control/base/units.h"
#include "control/lti/discretize.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace halbench::control {
namespace {

using Complex = std::complex<double>;

TransferFunction continuous(Polynomial numerator, Polynomial denominator) {
    return *TransferFunction::make(std::move(numerator), std::move(denominator), TimeBase::continuous());
}

/// Second route: the fundamental by numerical integration over one period (midpoints).
Complex fundamental(const std::function<double(double)>& outputAtPhase, double amplitude) {
    constexpr int Points = 200000;
    Complex sum = 0.0;
    for (int i = 0; i < Points; ++i) {
        const double phase = 2.0 * Pi * (i + 0.5) / Points;
        sum += outputAtPhase(phase) * Complex(std::sin(phase), std::cos(phase));
    }
    return 2.0 / Points * sum / amplitude;
}

TEST(DescribingFunction, ofASaturationIsItsFundamental) {
    for (const double A : {0.5, 1.0, 1.2, 3.0, 50.0}) {
        const Complex expected =
            fundamental([A](double phase) { return std::clamp(A * std::sin(phase), -1.0, 1.0); }, A);
        EXPECT_NEAR(saturationGain(A, 1.0), expected.real(), 1e-9); // midpoints of 2e5: h^2 at the corners
        EXPECT_NEAR(expected.imag(), 0.0, 1e-12);
    }
    for (const double gain : {0.01, 0.3, 0.99}) {
        EXPECT_NEAR(saturationGain(saturationAmplitude(gain, 2.0), 2.0), gain, 1e-13);
    }
}

TEST(DescribingFunction, ofARelayWithHysteresisIsItsFundamental) {
    for (const double h : {0.0, 0.3, 0.9}) {
        const double switching = std::asin(h);
        const Complex expected = fundamental(
            [switching](double phase) { return phase > switching && phase < Pi + switching ? 2.0 : -2.0; },
            1.0);
        EXPECT_LT(std::abs(relayGain(1.0, 2.0, h) - expected), 1e-4); // a jump is known to one point in 2e5
    }
}

TEST(DescribingFunction, coulombFrictionTakesTheEnergyOfItsEquivalentDamping) {
    const double A = 0.02;
    const double w = 30.0;
    // Work per cycle: 4 A F against pi c w A^2.
    EXPECT_NEAR(4.0 * A * 1.7, Pi * coulombDamping(1.7, A, w) * w * A * A, 1e-15);
}

// A relay in front of K/(s (s+1)(s+2)): w = sqrt 2, A = 4 M K/(6 pi) (Slotine, Li, section 5.4).
TEST(DescribingFunction, relayCycleOfTheTextbookLoopIsItsClosedForm) {
    const auto cycles = relayCycles(continuous({3.0}, {1.0, 3.0, 2.0, 0.0}), 2.0);
    ASSERT_TRUE(cycles.has_value());
    ASSERT_EQ(cycles->size(), 1u);
    EXPECT_NEAR((*cycles)[0].frequency_rad_s, std::sqrt(2.0), 1e-9);
    EXPECT_NEAR((*cycles)[0].amplitude, 4.0 * 2.0 * 3.0 / (6.0 * Pi), 1e-9);
    EXPECT_TRUE((*cycles)[0].isStable);
}

TEST(DescribingFunction, aConditionallyStableLoopHasAThresholdInsteadOfACycle) {
    // K (s+1)^2/s^3 is stable above K = 1/2: a saturated loop loses its gain and grows.
    const auto cycles = saturationCycles(continuous({2.0, 4.0, 2.0}, {1.0, 0.0, 0.0, 0.0}), 1.0);
    ASSERT_TRUE(cycles.has_value());
    ASSERT_EQ(cycles->size(), 1u);
    EXPECT_FALSE((*cycles)[0].isStable);
    EXPECT_NEAR((*cycles)[0].frequency_rad_s, 1.0, 1e-9);
    EXPECT_TRUE(saturationCycles(continuous({5.0}, {1.0, 3.0, 2.0, 0.0}), 1.0)->empty()); // K < 6
    EXPECT_EQ(saturationCycles(continuous({5.0}, {1.0, 1.0}), 0.0).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(relayCycles(continuous({5.0}, {1.0, 1.0}), 1.0, -1.0).error().code, ErrorCode::OutOfRange);
}

struct Oscillation {
    double amplitude = 0.0;
    double frequency_rad_s = 0.0;
};

/// Second route: the loop run on a fine grid until it repeats itself.
Oscillation simulated(const TransferFunction& loop, const std::function<double(double)>& element,
                      double step_s, double duration_s) {
    const StateSpace system = *discretize(toStateSpace(loop), step_s, Hold::Zoh{});
    Eigen::VectorXd x = Eigen::VectorXd::Zero(system.states());
    x(0) = 0.1;
    const int total = static_cast<int>(duration_s / step_s);
    double highest = 0.0;
    double last = 0.0;
    double first_s = -1.0;
    double end_s = 0.0;
    int turns = 0;
    for (int k = 0; k < total; ++k) {
        const double y = (system.C * x).value();
        if (k > total / 2) {
            highest = std::max(highest, y);
            if (last < 0.0 && y >= 0.0) {
                end_s = k * step_s;
                turns += first_s < 0.0 ? 0 : 1;
                first_s = first_s < 0.0 ? end_s : first_s;
            }
        }
        last = y;
        x = (system.A * x + system.B * element(-y)).eval();
    }
    return {highest, turns > 0 ? 2.0 * Pi * turns / (end_s - first_s) : 0.0};
}

TEST(DescribingFunction, predictsTheCyclesThatASimulationShows) {
    const auto loop = continuous({20.0}, {1.0, 3.0, 2.0, 0.0});
    const auto saturated = saturationCycles(loop, 0.5)->front();
    const auto clipped = simulated(
        loop, [](double u) { return std::clamp(u, -0.5, 0.5); }, 1e-3, 200.0);
    EXPECT_TRUE(saturated.isStable);
    // 10 %: what the third harmonic may move (CycleRoutes has the exact bound for a relay).
    EXPECT_NEAR(clipped.amplitude / saturated.amplitude, 1.0, 0.1);
    EXPECT_NEAR(clipped.frequency_rad_s / saturated.frequency_rad_s, 1.0, 0.1);

    const auto relay = relayCycles(loop, 0.5, 0.2)->front();
    double state = 0.5;
    const auto switched = simulated(
        loop,
        [&state](double u) {
            state = u > 0.2 ? 0.5 : u < -0.2 ? -0.5 : state;
            return state;
        },
        1e-3, 200.0);
    EXPECT_TRUE(relay.isStable);
    EXPECT_NEAR(switched.amplitude / relay.amplitude, 1.0, 0.1);
    EXPECT_NEAR(switched.frequency_rad_s / relay.frequency_rad_s, 1.0, 0.1);
}

} // namespace
} // namespace halbench::control
