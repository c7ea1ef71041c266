#pragma once

#include "control/base/result.h"

#include <array>
#include <complex>

namespace halbench::models {

/// Parts of one transconductance amplifier (voltage in, phase current out) and of the coil it drives.
/// Source: resources/help/htm-theory.md sections 2 and 3.2.
struct AmplifierParts {
    double R1_Ohm = 10e3;
    double R3_Ohm = 10e3;
    double R5_Ohm = 10e3;
    double R6_Ohm = 10e3;
    double R7_Ohm = 10e3;
    double R8_Ohm = 10e3;
    double R9_Ohm = 10e3;
    double R10_Ohm = 1.0; ///< the current shunt; the formula uses two in parallel
    double C2_F = 10e-9;
    double C3_F = 10e-9;
    double coil_Ohm = 1.5;  ///< R_a
    double coil_H = 152e-6; ///< L_a
};

/// I(s)/V(s) = gain (1 + zero s) / [(1 + first s + second s^2) (1 + lag s)]: the general formula
///   R3 R7 (R8+R9) (R6 C3 s + 1) /
///   { R1 R5 [ (R10/2)(R8+R9)(R6 C3 s + 1) + R9 R7 C3 (L_a s + R_a + R10/2) s ] (R3 C2 s + 1) }.
/// With the given parts zero = lag and 2 / (1 + 3.0e-4 s + 1.52e-8 s^2) A/V remains.
struct AmplifierModel {
    double gain_A_per_V = 0.0;
    double zero_s = 0.0;
    double first_s = 0.0;
    double second_s2 = 0.0;
    double lag_s = 0.0;
};

/// OutOfRange unless every part is positive and finite.
Result<AmplifierModel> amplifierModel(const AmplifierParts& parts);

/// The three poles, rad/s: the pair of the quadratic factor (real or conjugate), then -1/lag.
std::array<std::complex<double>, 3> amplifierPoles_rad_s(const AmplifierModel& model);

/// I(j 2 pi f)/V in A/V.
std::complex<double> amplifierResponse_A_per_V(const AmplifierModel& model, double frequency_Hz);

/// What evolves: quadratic factor's output and its scaled slope, the lag's output; all in volts.
struct AmplifierState {
    std::array<double, 3> x{};
};

/// Output over one step of constant input.
struct AmplifierCurrent {
    double atEnd_A = 0.0;
    double mean_A = 0.0; ///< exact average over the step; makes torque over the step exact
};

/// Exact update for an input that is constant over one step: the matrix exponential of the model (a sum of
/// its three exponentials, also when poles are complex or coincide) is computed once for the fixed step, so a
/// step costs about twelve multiplications and is stable at any size. A settled current stays exactly; modes
/// faster than 1e-5 of the step are taken as that fast.
class AmplifierStepper {
public:
    AmplifierStepper(const AmplifierModel& exact, double step_s);

    AmplifierCurrent step(AmplifierState& state, double input_V) const;
    /// The current that flows in this state.
    double current_A(const AmplifierState& state) const;
    /// The state in which `current` flows for ever when the input stays at current / gain.
    AmplifierState settledAt(double current_A) const;

private:
    double m_gain_A_per_V = 0.0;
    double m_lead = 0.0; ///< zero / lag: share of the quadratic factor's output that passes the lag directly
    std::array<std::array<double, 3>, 3> m_next{}; ///< of what differs from the settled state
    std::array<double, 3> m_mean{};
};

} // namespace halbench::models
