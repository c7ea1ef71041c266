// The loops of the six-coil planar positioner: a double integrator per axis behind an amplifier of 23.1 us
// and one sample of computing delay, at 1 kHz, under
//     v <- D v + (1 - D)(y[k] - y[k-1])/Ts,  D = exp(-Ts/Tf)
//     u = kp (b r - y) - kd v + I,           I <- I + ki Ts (r - y)
// with kp = w^2 + 4.4 w, kd = 2 w + 2.2, ki = 2.2 w^2 (poles at -2.2, -w, -w). Figures from the positioner's
// design; one unit of the last digit shown unless said otherwise.
#include "control/analysis/margins.h"
#include "control/analysis/nyquist.h"
#include "control/analysis/step_metrics.h"
#include "control/base/units.h"
#include "control/lti/discretize.h"
#include "control/lti/responses.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::control {
namespace {

constexpr double Ts = 1e-3;
const TimeBase Base = TimeBase::sampled(Ts);

struct Axis {
    double w = 30.0;
    double Tf = 2e-3;
    double inertiaShare = 1.0; ///< true inertia over the assumed one

    double kp() const { return w * w + 4.4 * w; }
    double kd() const { return 2.0 * w + 2.2; }
    double ki() const { return 2.2 * w * w; }
};

TransferFunction sampled(Polynomial numerator, Polynomial denominator) {
    return *TransferFunction::make(std::move(numerator), std::move(denominator), Base);
}

TransferFunction derivative(const Axis& axis) {
    const double D = std::exp(-Ts / axis.Tf);
    return sampled({axis.kd() * (1.0 - D) / Ts, -axis.kd() * (1.0 - D) / Ts}, {1.0, -D});
}

TransferFunction integral(const Axis& axis) {
    return sampled({axis.ki() * Ts}, {1.0, -1.0});
}

/// Of a demanded acceleration, with the delay.
TransferFunction plant(const Axis& axis) {
    constexpr double Amplifier_s = 23.1e-6;
    const auto continuous = *TransferFunction::make({1.0 / axis.inertiaShare}, {Amplifier_s, 1.0, 0.0, 0.0},
                                                    TimeBase::continuous());
    return *series(*discretize(continuous, Ts, Hold::Zoh{}), TransferFunction::delay(1, Ts));
}

TransferFunction openLoop(const Axis& axis) {
    const auto controller =
        parallel(*parallel(TransferFunction::gain(axis.kp(), Base), integral(axis)), derivative(axis));
    return *series(*controller, plant(axis));
}

/// From r to y: F G/(1 + C G); `b` weighs r in the proportional term, `c` in the derivative.
TransferFunction closedLoop(const Axis& axis, double b, double c) {
    const auto P = plant(axis);
    const auto C =
        *parallel(*parallel(TransferFunction::gain(axis.kp(), Base), integral(axis)), derivative(axis));
    const double D = std::exp(-Ts / axis.Tf);
    // F over the denominator of C, (z - 1)(z - D), so that nothing is cancelled.
    const Polynomial integrator = {1.0, -1.0};
    const Polynomial filter = {1.0, -D};
    const Polynomial slope = scale(multiply(integrator, integrator), axis.kd() * (1.0 - D) / Ts);
    const Polynomial F =
        add(add(scale(multiply(integrator, filter), b * axis.kp()), scale(filter, axis.ki() * Ts)),
            scale(slope, c));
    const Polynomial closed =
        add(multiply(C.denominator(), P.denominator()), multiply(C.numerator(), P.numerator()));
    return sampled(multiply(F, P.numerator()), closed);
}

double hertz(double frequency_rad_s) {
    return frequency_rad_s / (2.0 * Pi);
}

/// Gain margins below (the gain must not fall) and above, as printed.
std::vector<Crossing> phaseCrossings(const TransferFunction& loop) {
    std::vector<Crossing> result;
    for (const Crossing& crossing : allCrossings(loop)) {
        if (crossing.kind == Crossing::Kind::Phase) {
            result.push_back(crossing);
        }
    }
    return result;
}

const Axis X{30.0, 2e-3};
const Axis Phi{60.0, 2e-3};

TEST(PlanarLoop, gainsAreThoseOfThePlacedPoles) {
    EXPECT_NEAR(X.kp(), 1032.0, 1e-9);
    EXPECT_NEAR(X.ki(), 1980.0, 1e-9);
    EXPECT_NEAR(X.kd(), 62.2, 1e-12);
    EXPECT_NEAR(Phi.kp(), 3864.0, 1e-9);
    EXPECT_NEAR(Phi.ki(), 7920.0, 1e-9);
    EXPECT_NEAR(Phi.kd(), 122.2, 1e-12);
}

TEST(PlanarLoop, openLoopPassesThroughThePrintedPoints) {
    const auto loop = openLoop(X);
    const struct {
        double frequency_Hz;
        double magnitude_dB;
        double phase_deg;
    } points[] = {{1.0, 28.40, -176.4}, {10.0, 0.344, -117.3}, {50.0, -15.25, -153.2}};
    for (const auto& point : points) {
        const auto value = loop.atFrequency(2.0 * Pi * point.frequency_Hz);
        EXPECT_NEAR(20.0 * std::log10(std::abs(value)), point.magnitude_dB, 0.005);
        EXPECT_NEAR(radiansToDegrees(std::arg(value)), point.phase_deg, 0.05);
    }
}

TEST(PlanarLoop, marginsOfTheAxesAreThoseOfTheDesign) {
    const auto x = smallestMargins(openLoop(X));
    EXPECT_NEAR(hertz(x.gainCrossover_rad_s.value()), 10.38, 0.01);
    EXPECT_NEAR(x.phaseMargin_deg, 62.8, 0.1);
    const auto crossings = phaseCrossings(openLoop(X));
    ASSERT_EQ(crossings.size(), 3u); // the last one at the Nyquist frequency
    EXPECT_NEAR(crossings[2].frequency_rad_s, Pi / Ts, 1e-9);
    EXPECT_NEAR(20.0 * std::log10(crossings[0].gainMargin_ratio), -30.0, 0.1);
    EXPECT_NEAR(hertz(crossings[0].frequency_rad_s), 0.91, 0.01);
    EXPECT_NEAR(20.0 * std::log10(crossings[1].gainMargin_ratio), 20.6, 0.1);
    EXPECT_NEAR(hertz(crossings[1].frequency_rad_s), 77.8, 0.1);
    EXPECT_NEAR(sensitivityPeaks(openLoop(X)).Ms_ratio, 1.22, 0.01);

    const auto phi = smallestMargins(openLoop(Phi));
    EXPECT_NEAR(hertz(phi.gainCrossover_rad_s.value()), 20.5, 0.1);
    EXPECT_NEAR(phi.phaseMargin_deg, 51.0, 0.1);
    const auto phiCrossings = phaseCrossings(openLoop(Phi));
    ASSERT_EQ(phiCrossings.size(), 3u);
    EXPECT_NEAR(20.0 * std::log10(phiCrossings[0].gainMargin_ratio), -35.1, 0.1);
    EXPECT_NEAR(hertz(phiCrossings[0].frequency_rad_s), 1.3, 0.1);
    EXPECT_NEAR(20.0 * std::log10(phiCrossings[1].gainMargin_ratio), 14.2, 0.1);
    EXPECT_NEAR(hertz(phiCrossings[1].frequency_rad_s), 76.0, 1.0);
    EXPECT_NEAR(sensitivityPeaks(openLoop(Phi)).Ms_ratio, 1.50, 0.01);
}

TEST(PlanarLoop, bothAxesAreStableByNyquistAndByTheirRoots) {
    for (const Axis& axis : {X, Phi}) {
        EXPECT_EQ(nyquist(openLoop(axis))->unstableClosedLoopPoles, 0);
        EXPECT_TRUE(isStable(closedLoop(axis, 1.0, 0.0)));
    }
}

TEST(PlanarLoop, theTuningTradeIsThePrintedOne) {
    const struct {
        Axis axis;
        double crossover_Hz;
        double margin_deg;
    } trades[] = {{{60.0, 1e-3}, 20.4, 57.4},
                  {{90.0, 0.5e-3}, 30.4, 52.8},
                  {{120.0, 0.5e-3}, 40.6, 45.1},
                  {{60.0, 2e-3, 2.7}, 8.6, 49.6},
                  {{60.0, 2e-3, 0.5}, 37.6, 36.4}};
    for (const auto& trade : trades) {
        const auto margins = smallestMargins(openLoop(trade.axis));
        EXPECT_NEAR(hertz(margins.gainCrossover_rad_s.value()), trade.crossover_Hz, 0.1);
        EXPECT_NEAR(margins.phaseMargin_deg, trade.margin_deg, 0.1);
    }
    const auto uncalibrated = smallestMargins(openLoop({30.0, 2e-3, 1.0 / 1.137}));
    EXPECT_NEAR(hertz(uncalibrated.gainCrossover_rad_s.value()), 11.7, 0.1);
}

StepMetrics stepOf(const Axis& axis, double b, double c) {
    const auto response = stepResponse(closedLoop(axis, b, c), 5.0, Ts);
    return *measureStep(response->time_s, response->value, 0.0, 1.0);
}

TEST(PlanarLoop, stepsAreThoseOfTheDesign) {
    EXPECT_NEAR(stepOf(X, 0.745, 0.0).riseTime_s.value(), 0.245, 0.001);
    EXPECT_NEAR(stepOf(X, 0.745, 0.0).settlingTime_s.value(), 0.968, 0.001);
    EXPECT_LT(stepOf(X, 0.745, 0.0).overshoot_percent, 0.05);
    EXPECT_NEAR(stepOf(Phi, 0.745, 0.0).riseTime_s.value(), 0.339, 0.001);
    EXPECT_NEAR(stepOf(Phi, 0.745, 0.0).settlingTime_s.value(), 1.079, 0.001);
    EXPECT_LT(stepOf(Phi, 0.745, 0.0).overshoot_percent, 0.05);
    EXPECT_NEAR(stepOf(X, 1.0, 1.0).overshoot_percent, 17.5, 0.1);
    // With the derivative on the error the first difference kicks; the design does not say how it was taken.
    EXPECT_NEAR(stepOf(Phi, 1.0, 1.0).overshoot_percent, 23.9, 0.3);
    EXPECT_NEAR(stepOf(X, 1.0, 0.0).overshoot_percent, 8.9, 0.1);
}

// The plant integrates twice, so the integral of the error is fixed: kp (1 - b)/ki times the step; 0 with b
// = 1.
TEST(PlanarLoop, theIntegralOfTheErrorIsFixedByTheWeight) {
    for (const double b : {0.745, 1.0}) {
        const auto response = stepResponse(closedLoop(X, b, 0.0), 20.0, Ts);
        double integral_s = 0.0;
        for (const double y : response->value) {
            integral_s += Ts * (1.0 - y);
        }
        EXPECT_NEAR(integral_s, X.kp() * (1.0 - b) / X.ki(), 1e-6); // exp(-2.2 * 20) is left
        EXPECT_NEAR(X.kp() * (1.0 - 0.745) / X.ki(), 0.13291, 0.5e-5);
    }
}

} // namespace
} // namespace halbench::control
