// Describing functions and limit cycles of random loops: the fundamental by numerical integration, the
// balance closed with it, and the exact cycle of a relay from the states at its switching (Tsypkin; Astrom
// 1995).
#include "control/analysis/describing_function.h"
#include "control/analysis/margins.h"
#include "control/base/units.h"
#include "tests/control/routes/random_loops.h"
#include "tests/control/routes/state_routes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <unsupported/Eigen/MatrixFunctions>

namespace halbench::control {
namespace {

using Complex = std::complex<double>;

/// (2/pi)/A times the integral of output(phase) (sin + j cos) over the half turn from `from`, the rest being
/// its mirror image: Simpson between the corners, where the output is smooth.
Complex fundamental(const std::function<double(double)>& output, std::vector<double> corners,
                    double amplitude) {
    const auto part = [&output](double low, double high) {
        constexpr int Parts = 2000;
        const double h = (high - low) / Parts;
        Complex sum = 0.0;
        for (int i = 0; i <= Parts; ++i) {
            const double phase = low + h * i;
            // At the ends from the inside: the output jumps there.
            const double value = output(std::clamp(phase, low + 1e-12, high - 1e-12));
            const double weight = i == 0 || i == Parts ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
            sum += weight * value * Complex(std::sin(phase), std::cos(phase));
        }
        return h / 3.0 * sum;
    };
    Complex whole = 0.0;
    for (std::size_t i = 1; i < corners.size(); ++i) {
        whole += part(corners[i - 1], corners[i]);
    }
    return 2.0 / Pi * whole / amplitude;
}

Complex saturated(double amplitude, double limit) {
    const double corner = std::asin(std::min(1.0, limit / amplitude));
    return fundamental([&](double phase) { return std::clamp(amplitude * std::sin(phase), -limit, limit); },
                       {0.0, corner, Pi - corner, Pi}, amplitude);
}

Complex switched(double amplitude, double level, double hysteresis) {
    const double corner = std::asin(hysteresis / amplitude);
    return fundamental([&](double) { return level; }, {corner, Pi + corner}, amplitude);
}

// Simpson with 2000 parts of a smooth stretch: (h/2)^4 pi/180 = 1e-14.
TEST(CycleRoutes, gainsOfRandomElementsAreTheirFourierIntegrals) {
    Random random(131);
    for (int round = 0; round < 200; ++round) {
        const double limit = std::exp(random.gaussian());
        const double amplitude = limit * (0.3 + 5.0 * random.uniform());
        EXPECT_LT(std::abs(saturated(amplitude, limit) - saturationGain(amplitude, limit)), 1e-10);
        const double gain = 0.02 + 0.97 * random.uniform();
        EXPECT_NEAR(saturationGain(saturationAmplitude(gain, limit), limit), gain, 1e-12);
        const double hysteresis = amplitude * 0.99 * random.uniform();
        const Complex relay = relayGain(amplitude, limit, hysteresis);
        EXPECT_LT(std::abs(switched(amplitude, limit, hysteresis) / relay - 1.0), 1e-10);
        const double w = std::exp(random.gaussian());
        // The work of the friction over a turn, by the same integral of level sgn(v) v.
        const Complex friction = fundamental([&](double) { return limit; }, {-0.5 * Pi, 0.5 * Pi}, amplitude);
        EXPECT_NEAR(coulombDamping(limit, amplitude, w) * w, friction.imag(), 1e-10 * friction.imag());
    }
}

// 1 + N(A) L = 0 with N by integration; as many cycles as the crossings of the negative real axis allow.
TEST(CycleRoutes, everyCycleBalancesItsLoop) {
    Random random(132);
    int saturating = 0;
    int relays = 0;
    for (int round = 0; round < 200; ++round) {
        const auto [loop, states] = randomLoop(random, round);
        const double limit = std::exp(random.gaussian());
        const auto cycles = saturationCycles(loop, limit);
        const auto plain = relayCycles(loop, limit);
        const auto late = relayCycles(loop, limit, 0.1 * limit);
        ASSERT_TRUE(cycles && plain && late) << round;
        std::size_t beyond = 0;
        std::size_t all = 0;
        for (const Crossing& crossing : allCrossings(loop)) {
            const bool isPhase = crossing.kind == Crossing::Kind::Phase;
            all += isPhase ? 1 : 0;
            beyond += isPhase && crossing.gainMargin_ratio < 1.0 ? 1 : 0;
        }
        EXPECT_EQ(cycles->size(), beyond) << round;
        EXPECT_EQ(plain->size(), all) << round;
        const auto rest = [&loop](const LimitCycle& cycle, Complex gain) {
            return std::abs(1.0 + gain * loop.atFrequency(cycle.frequency_rad_s));
        };
        for (const LimitCycle& cycle : *cycles) {
            // The frequency is known to its rounding, times what the loop turns there.
            EXPECT_LT(rest(cycle, saturated(cycle.amplitude, limit)), 1e-9) << round;
            ++saturating;
        }
        for (const LimitCycle& cycle : *plain) {
            EXPECT_LT(rest(cycle, switched(cycle.amplitude, limit, 0.0)), 1e-9) << round;
        }
        for (const LimitCycle& cycle : *late) {
            EXPECT_LT(rest(cycle, switched(cycle.amplitude, limit, 0.1 * limit)), 1e-9) << round;
            ++relays;
        }
    }
    EXPECT_GT(saturating, 20);
    EXPECT_GT(relays, 50);
}

/// The output at the moment of switching when a relay of `level` swings with half a turn of `half_s`:
/// x0 = -(1 + Phi)^-1 Gamma level is the state that is its own negative half a turn later.
double switchingOutput(const StateSpace& plant, double level, double half_s) {
    const Eigen::Index n = plant.states();
    Eigen::MatrixXd joined = Eigen::MatrixXd::Zero(n + 1, n + 1);
    joined << plant.A * half_s, plant.B * half_s, Eigen::RowVectorXd::Zero(n + 1);
    const Eigen::MatrixXd moved = joined.exp();
    const Eigen::MatrixXd Phi = moved.topLeftCorner(n, n);
    const Eigen::VectorXd Gamma = moved.topRightCorner(n, 1);
    const Eigen::VectorXd x0 = -(Eigen::MatrixXd::Identity(n, n) + Phi).fullPivLu().solve(Gamma * level);
    return (plant.C * x0).value();
}

// Against the exact cycle. The third harmonic, a third of |L(3 j w)/L(j w)| of the first, moves the moment of
// switching by at most that angle, and the frequency by that over the slope of the phase; twice with those
// that follow it.
TEST(CycleRoutes, aRelaysCycleIsTheExactOneButForItsThirdHarmonic) {
    Random random(133);
    int checked = 0;
    for (int round = 0; round < 200; ++round) {
        const auto loop = randomSystem(random, 3 + static_cast<int>(random.below(3)), true);
        if (degree(loop.denominator()) - degree(loop.numerator()) < 3) {
            continue; // no low pass: the method does not apply
        }
        const double level = std::exp(random.gaussian());
        const auto cycles = relayCycles(loop, level);
        ASSERT_TRUE(cycles.has_value());
        for (const LimitCycle& cycle : *cycles) {
            const double w = cycle.frequency_rad_s;
            const double third = std::abs(loop.atFrequency(3.0 * w) / loop.atFrequency(w)) / 3.0;
            if (!cycle.isStable || third > 0.05) {
                continue;
            }
            const StateSpace plant = sectionsOf(loop);
            double low = 0.7 * Pi / w;
            double high = 1.4 * Pi / w;
            const bool isRising = switchingOutput(plant, level, low) < 0.0;
            for (int i = 0; i < 60; ++i) {
                const double middle = 0.5 * (low + high);
                ((switchingOutput(plant, level, middle) < 0.0) == isRising ? low : high) = middle;
            }
            const double turn_rad =
                std::arg(loop.atFrequency(1.001 * w) / loop.atFrequency(0.999 * w)) / 0.002;
            EXPECT_NEAR(Pi / low / w, 1.0, 2.0 * third / std::abs(turn_rad)) << round;
            ++checked;
        }
    }
    EXPECT_GT(checked, 20);
}

} // namespace
} // namespace halbench::control
