#include "models/drives/amplifier.h"

#include "control/base/assert.h"
#include "control/base/units.h"

#include <cmath>

namespace halbench::models {
namespace {

/// The three states as they differ from those the input settles at, and the integral of the current.
constexpr std::size_t Size = 4;
using Matrix = std::array<std::array<double, Size>, Size>;

Matrix product(const Matrix& left, const Matrix& right) {
    Matrix result{};
    for (std::size_t row = 0; row < Size; ++row) {
        for (std::size_t inner = 0; inner < Size; ++inner) {
            for (std::size_t column = 0; column < Size; ++column) {
                result[row][column] += left[row][inner] * right[inner][column];
            }
        }
    }
    return result;
}

double largestRowSum(const Matrix& matrix) {
    double largest = 0.0;
    for (const auto& row : matrix) {
        double sum = 0.0;
        for (const double value : row) {
            sum += std::abs(value);
        }
        largest = std::fmax(largest, sum);
    }
    return largest;
}

/// exp(M) by scaling to a row sum below 1/2, the Taylor sum (18 terms leave less than 1e-21) and squaring.
Matrix exponential(Matrix matrix) {
    const int halvings = static_cast<int>(std::ceil(std::log2(std::fmax(2.0 * largestRowSum(matrix), 1.0))));
    for (auto& row : matrix) {
        for (double& value : row) {
            value = std::ldexp(value, -halvings);
        }
    }
    Matrix term{};
    for (std::size_t i = 0; i < Size; ++i) {
        term[i][i] = 1.0;
    }
    Matrix sum = term;
    for (int order = 1; order <= 18; ++order) {
        term = product(term, matrix);
        for (std::size_t row = 0; row < Size; ++row) {
            for (std::size_t column = 0; column < Size; ++column) {
                term[row][column] /= order;
                sum[row][column] += term[row][column];
            }
        }
    }
    for (int i = 0; i < halvings; ++i) {
        sum = product(sum, sum);
    }
    return sum;
}

/// Modes that are over within a hundred-thousandth of a step become as fast as that: the current changes by
/// less than that part of a step, and the squarings of the exponential keep eleven digits of the slow modes.
AmplifierModel resolvable(AmplifierModel model, double step_s) {
    const double shortest_s = 1e-5 * step_s;
    const auto poles = amplifierPoles_rad_s(model);
    const double near_s = 1.0 / std::abs(poles[0]);
    const double far_s = 1.0 / std::abs(poles[1]);
    if (far_s < shortest_s) {
        const double kept_s = std::fmax(near_s, shortest_s);
        model.first_s = kept_s + shortest_s;
        model.second_s2 = kept_s * shortest_s;
    }
    model.lag_s = std::fmax(model.lag_s, shortest_s);
    return model;
}

/// x0: output w of the quadratic factor, x1: tau w' with tau^2 = second, x2: output v of the lag;
/// current = gain (v + zero v') with lag v' = w - v. A constant input V settles at w = v = V.
Matrix timesStep(const AmplifierModel& model, double step_s) {
    const double tau = std::sqrt(model.second_s2);
    const double lead = model.zero_s / model.lag_s;
    Matrix rate{};
    rate[0][1] = step_s / tau;
    rate[1][0] = -step_s / tau;
    rate[1][1] = -step_s * model.first_s / model.second_s2;
    rate[2][0] = step_s / model.lag_s;
    rate[2][2] = -step_s / model.lag_s;
    rate[3][0] = model.gain_A_per_V * lead; // integral over the step divided by the step
    rate[3][2] = model.gain_A_per_V * (1.0 - lead);
    return rate;
}

} // namespace

Result<AmplifierModel> amplifierModel(const AmplifierParts& parts) {
    for (const double value :
         {parts.R1_Ohm, parts.R3_Ohm, parts.R5_Ohm, parts.R6_Ohm, parts.R7_Ohm, parts.R8_Ohm, parts.R9_Ohm,
          parts.R10_Ohm, parts.C2_F, parts.C3_F, parts.coil_Ohm, parts.coil_H}) {
        if (!(value > 0.0) || !std::isfinite(value)) {
            return failure(ErrorCode::OutOfRange, "Every amplifier part must be positive and finite.",
                           "Check resistors, capacitors and the coil's resistance and inductance.");
        }
    }
    const double shunt = 0.5 * parts.R10_Ohm;
    const double divider = parts.R8_Ohm + parts.R9_Ohm;
    const double constant = shunt * divider;
    const double feedback = parts.R9_Ohm * parts.R7_Ohm * parts.C3_F;

    AmplifierModel model;
    model.gain_A_per_V = parts.R3_Ohm * parts.R7_Ohm * divider / (parts.R1_Ohm * parts.R5_Ohm * constant);
    model.zero_s = parts.R6_Ohm * parts.C3_F;
    model.first_s = model.zero_s + feedback * (parts.coil_Ohm + shunt) / constant;
    model.second_s2 = feedback * parts.coil_H / constant;
    model.lag_s = parts.R3_Ohm * parts.C2_F;
    return model;
}

std::array<std::complex<double>, 3> amplifierPoles_rad_s(const AmplifierModel& model) {
    const std::complex<double> root =
        std::sqrt(std::complex<double>(model.first_s * model.first_s - 4.0 * model.second_s2));
    // The far pole by the sum, the near one by the product: no cancellation.
    const std::complex<double> far = -(model.first_s + root) / (2.0 * model.second_s2);
    const std::complex<double> near = 1.0 / (model.second_s2 * far);
    return {near, far, -1.0 / model.lag_s};
}

std::complex<double> amplifierResponse_A_per_V(const AmplifierModel& model, double frequency_Hz) {
    const std::complex<double> s(0.0, 2.0 * Pi * frequency_Hz);
    return model.gain_A_per_V * (1.0 + model.zero_s * s) /
           ((1.0 + model.first_s * s + model.second_s2 * s * s) * (1.0 + model.lag_s * s));
}

AmplifierStepper::AmplifierStepper(const AmplifierModel& exact, double step_s) {
    HB_ASSERT(step_s > 0.0 && exact.second_s2 > 0.0 && exact.lag_s > 0.0);
    const AmplifierModel model = resolvable(exact, step_s);
    m_gain_A_per_V = model.gain_A_per_V;
    m_lead = model.zero_s / model.lag_s;
    const Matrix transition = exponential(timesStep(model, step_s));
    for (std::size_t column = 0; column < 3; ++column) {
        for (std::size_t row = 0; row < 3; ++row) {
            m_next[row][column] = transition[row][column];
        }
        m_mean[column] = transition[3][column];
    }
}

AmplifierCurrent AmplifierStepper::step(AmplifierState& state, double input_V) const {
    const std::array<double, 3> away = {state.x[0] - input_V, state.x[1], state.x[2] - input_V};
    const auto combine = [&](const std::array<double, 3>& row) {
        return row[0] * away[0] + row[1] * away[1] + row[2] * away[2];
    };
    AmplifierCurrent current;
    current.mean_A = m_gain_A_per_V * input_V + combine(m_mean);
    state.x = {input_V + combine(m_next[0]), combine(m_next[1]), input_V + combine(m_next[2])};
    current.atEnd_A = current_A(state);
    return current;
}

double AmplifierStepper::current_A(const AmplifierState& state) const {
    return m_gain_A_per_V * (state.x[2] + m_lead * (state.x[0] - state.x[2]));
}

AmplifierState AmplifierStepper::settledAt(double current_A) const {
    const double level_V = current_A / m_gain_A_per_V;
    return {{level_V, 0.0, level_V}};
}

} // namespace halbench::models
