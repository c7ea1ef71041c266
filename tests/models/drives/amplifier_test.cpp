#include "control/base/random.h"
#include "control/base/units.h"
#include "models/drives/amplifier.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace halbench::models {
namespace {

AmplifierModel givenModel() {
    return amplifierModel(AmplifierParts{}).value();
}

double phase_deg(const AmplifierModel& model, double frequency_Hz) {
    return radiansToDegrees(std::arg(amplifierResponse_A_per_V(model, frequency_Hz)));
}

double gain_dB(const AmplifierModel& model, double frequency_Hz) {
    return 20.0 * std::log10(std::abs(amplifierResponse_A_per_V(model, frequency_Hz)));
}

/// Independent route: the printed formula with all factors written out.
std::complex<double> printedFormula(const AmplifierParts& p, double frequency_Hz) {
    const std::complex<double> s(0.0, 2.0 * Pi * frequency_Hz);
    const auto numerator = p.R3_Ohm * p.R7_Ohm * (p.R8_Ohm + p.R9_Ohm) * (p.R6_Ohm * p.C3_F * s + 1.0);
    const auto bracket = (p.R10_Ohm / 2.0) * (p.R8_Ohm + p.R9_Ohm) * (p.R6_Ohm * p.C3_F * s + 1.0) +
                         p.R9_Ohm * p.R7_Ohm * p.C3_F * (p.coil_H * s + p.coil_Ohm + p.R10_Ohm / 2.0) * s;
    return numerator / (p.R1_Ohm * p.R5_Ohm * bracket * (p.R3_Ohm * p.C2_F * s + 1.0));
}

/// Step response of 2 / ((1 + s/p1)(1 + s/p2)) by its two exponentials.
double twoExponentials_A(double time_s, double input_V) {
    // roots of 1.52e-8 s^2 + 3.0e-4 s + 1
    const double p1 = (3.0e-4 - std::sqrt(9.0e-8 - 4.0 * 1.52e-8)) / (2.0 * 1.52e-8);
    const double p2 = (3.0e-4 + std::sqrt(9.0e-8 - 4.0 * 1.52e-8)) / (2.0 * 1.52e-8);
    return 2.0 * input_V * (1.0 - (p2 * std::exp(-p1 * time_s) - p1 * std::exp(-p2 * time_s)) / (p2 - p1));
}

TEST(Amplifier, givenPartsReduceToTheQuotedSecondOrderForm) {
    const AmplifierModel model = givenModel();
    EXPECT_DOUBLE_EQ(model.gain_A_per_V, 2.0);
    EXPECT_NEAR(model.first_s, 3.0e-4, 1e-18);
    EXPECT_NEAR(model.second_s2, 1.52e-8, 1e-22);
    EXPECT_NEAR(model.zero_s, model.lag_s, 1e-19); // the zero cancels this pole
}

TEST(Amplifier, polesAreTheQuotedFrequencies) {
    const auto poles = amplifierPoles_rad_s(givenModel());
    EXPECT_NEAR(-poles[0].real() / (2.0 * Pi), 675.99, 5e-3);
    EXPECT_NEAR(-poles[1].real() / (2.0 * Pi), 2465.23, 5e-3);
    EXPECT_EQ(poles[0].imag(), 0.0);
    EXPECT_EQ(poles[1].imag(), 0.0);
}

TEST(Amplifier, frequencyResponseMeetsTheQuotedPoints) {
    const AmplifierModel model = givenModel();
    EXPECT_NEAR(phase_deg(model, 10.0), -1.080, 5e-4);
    EXPECT_NEAR(phase_deg(model, 100.0), -10.74, 5e-3);
    EXPECT_NEAR(phase_deg(model, 1e3), -78.0, 5e-2);
    EXPECT_NEAR(gain_dB(model, 1e3), 0.32, 5e-3);
    EXPECT_NEAR(phase_deg(model, 1e4), -162.3, 5e-2);
    EXPECT_NEAR(gain_dB(model, 1e4), -29.8, 5e-2);
    // -3 dB (half power) below the 2 A/V of direct current
    EXPECT_NEAR(std::norm(amplifierResponse_A_per_V(model, 632.8) / 2.0), 0.5, 2e-4);
}

TEST(Amplifier, responseEqualsThePrintedFormulaForOtherParts) {
    AmplifierParts parts;
    parts.R1_Ohm = 12e3;
    parts.R3_Ohm = 8e3;
    parts.R5_Ohm = 15e3;
    parts.R6_Ohm = 5e3;
    parts.R7_Ohm = 11e3;
    parts.R8_Ohm = 9e3;
    parts.R9_Ohm = 13e3;
    parts.R10_Ohm = 0.7;
    parts.C2_F = 4.7e-9;
    parts.C3_F = 22e-9;
    parts.coil_H = 600e-6;
    const AmplifierModel model = amplifierModel(parts).value();
    for (const double frequency_Hz : {0.0, 10.0, 300.0, 3e3, 4e4}) {
        const auto expected = printedFormula(parts, frequency_Hz);
        EXPECT_NEAR(std::abs(amplifierResponse_A_per_V(model, frequency_Hz) / expected - 1.0), 0.0, 1e-13);
    }
}

TEST(Amplifier, stepIsTheSumOfTwoExponentialsAtAnyStepSize) {
    for (const double step_s : {1e-5, 2.5e-4, 1e-3, 0.5}) {
        const AmplifierStepper stepper(givenModel(), step_s);
        AmplifierState state;
        for (int i = 1; i <= 20; ++i) {
            EXPECT_NEAR(stepper.step(state, 1.5).atEnd_A, twoExponentials_A(i * step_s, 1.5), 1e-12);
        }
    }
}

TEST(Amplifier, halvingTheStepChangesNothing) {
    AmplifierParts resonant; // a large coil gives a conjugate pair, other capacitors leave the zero
    resonant.coil_H = 3e-3;
    resonant.C2_F = 3e-9;
    const AmplifierModel model = amplifierModel(resonant).value();
    ASSERT_NE(amplifierPoles_rad_s(model)[0].imag(), 0.0);
    const AmplifierStepper coarse(model, 1e-3);
    const AmplifierStepper fine(model, 2.5e-4);
    AmplifierState one;
    AmplifierState four;
    for (int i = 0; i < 40; ++i) {
        const double input_V = std::sin(0.7 * i);
        const AmplifierCurrent whole = coarse.step(one, input_V);
        double mean_A = 0.0;
        double end_A = 0.0;
        for (int part = 0; part < 4; ++part) {
            const AmplifierCurrent quarter = fine.step(four, input_V);
            mean_A += 0.25 * quarter.mean_A;
            end_A = quarter.atEnd_A;
        }
        EXPECT_NEAR(whole.atEnd_A, end_A, 1e-12);
        EXPECT_NEAR(whole.mean_A, mean_A, 1e-12);
    }
}

TEST(Amplifier, meanIsTheAverageOfTheCurrentOverTheStep) {
    const AmplifierStepper whole(givenModel(), 2.5e-4);
    const AmplifierStepper fine(givenModel(), 2.5e-7);
    AmplifierState state;
    AmplifierState sliced;
    const double mean_A = whole.step(state, 2.0).mean_A;
    double sum_A = 0.0;
    double before_A = 0.0;
    for (int i = 0; i < 1000; ++i) {
        const double after_A = fine.step(sliced, 2.0).atEnd_A;
        sum_A += 0.5e-3 * (before_A + after_A);
        before_A = after_A;
    }
    EXPECT_NEAR(mean_A, sum_A, 1e-6); // trapezoid over 1000 slices: error about (dt/tau)^2/12
}

TEST(Amplifier, settledStateKeepsItsCurrentForEver) {
    const AmplifierStepper stepper(givenModel(), 2.5e-4);
    AmplifierState state = stepper.settledAt(3.2);
    EXPECT_DOUBLE_EQ(stepper.current_A(state), 3.2);
    for (int i = 0; i < 1000; ++i) {
        const AmplifierCurrent current = stepper.step(state, 1.6);
        EXPECT_NEAR(current.atEnd_A, 3.2, 1e-12);
        EXPECT_NEAR(current.mean_A, 3.2, 1e-12);
    }
}

TEST(Amplifier, settlesAtItsGainWithAnyPartsAllowed) {
    // Time constants from 1e-12 s to 100 s in one amplifier: the squarings of a plain exponential would let
    // the rounding of the slow mode grow without bound.
    Random random(1);
    const auto drawn = [&random](double low, double high) {
        return low * std::pow(high / low, random.uniform());
    };
    for (int i = 0; i < 1000; ++i) {
        AmplifierParts parts;
        for (double* resistor : {&parts.R1_Ohm, &parts.R3_Ohm, &parts.R5_Ohm, &parts.R6_Ohm, &parts.R7_Ohm,
                                 &parts.R8_Ohm, &parts.R9_Ohm}) {
            *resistor = drawn(1.0, 1e7);
        }
        parts.R10_Ohm = drawn(1e-3, 1e3);
        parts.C2_F = drawn(1e-12, 1e-5);
        parts.C3_F = drawn(1e-12, 1e-5);
        parts.coil_H = drawn(1e-7, 0.1);
        const AmplifierModel model = amplifierModel(parts).value();
        const AmplifierStepper stepper(model, 2.5e-4);
        AmplifierState state = stepper.settledAt(model.gain_A_per_V * 1.5);
        const AmplifierCurrent current = stepper.step(state, 1.5);
        ASSERT_NEAR(current.atEnd_A / (1.5 * model.gain_A_per_V), 1.0, 1e-12);
        ASSERT_NEAR(current.mean_A / (1.5 * model.gain_A_per_V), 1.0, 1e-12);
        AmplifierState rising;
        for (int k = 0; k < 1000; ++k) {
            ASSERT_TRUE(std::isfinite(stepper.step(rising, 1.0).atEnd_A));
        }
    }
}

TEST(Amplifier, shortensOnlyModesThatAreOverAtOnce) {
    // Poles of 1 us and below beside one of 0.2 ms, steps of 10 ms: e^(-50) is left, the mean lacks the
    // slow time constant's area 0.2/10 (1 - e^(-50)).
    AmplifierParts parts;
    parts.R6_Ohm = 1.0;
    parts.C3_F = 1e-12;
    parts.coil_H = 1e-7;
    parts.R3_Ohm = 20e3;
    const AmplifierModel model = amplifierModel(parts).value(); // lag = R3 C2 = 0.2 ms
    const AmplifierStepper stepper(model, 1e-2);
    AmplifierState state;
    const AmplifierCurrent current = stepper.step(state, 1.0);
    EXPECT_NEAR(current.atEnd_A / model.gain_A_per_V, 1.0, 1e-12);
    EXPECT_NEAR(current.mean_A / model.gain_A_per_V, 1.0 - 0.02, 2e-5); // 1e-5 for each shortened mode
}

TEST(Amplifier, toleratesCoincidingPoles) {
    AmplifierParts parts;
    // first^2 = 4 second: 9e-8 = 4 * L / 1e4 -> L = 225 uH; both poles at 1/1.5e-4 s, and so the lag.
    parts.coil_H = 225e-6;
    parts.C2_F = 15e-9;
    const AmplifierModel model = amplifierModel(parts).value();
    const AmplifierStepper stepper(model, 1.5e-4);
    AmplifierState state;
    // 2 (1 + 1e-4 s)/(1 + T s)^3 at t = T: 2 [1 - e^-1 (1 + 1 + 1/2) + (2/3) e^-1 / 2]
    const double expected_A = 2.0 * (1.0 - std::exp(-1.0) * 2.5 + (2.0 / 3.0) * 0.5 * std::exp(-1.0));
    EXPECT_NEAR(stepper.step(state, 1.0).atEnd_A, expected_A, 1e-9);
}

TEST(Amplifier, refusesPartsThatDoNotExist) {
    AmplifierParts parts;
    parts.C3_F = 0.0;
    EXPECT_EQ(amplifierModel(parts).error().code, ErrorCode::OutOfRange);
    parts = AmplifierParts{};
    parts.R10_Ohm = std::numeric_limits<double>::infinity();
    EXPECT_EQ(amplifierModel(parts).error().code, ErrorCode::OutOfRange);
}

} // namespace
} // namespace halbench::models
