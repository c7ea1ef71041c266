#pragma once

#include "control/law/shaped_law.h"

#include <utility>
#include <vector>

namespace halbench::control {

/// What the difference equation of a law computes with.
struct ShapedEquation {
    PidGains gains; ///< parallel form, per radian
    double proportionalWeight = 1.0;
    double derivativeWeight = 0.0;
    double period_s = 0.0;
    std::vector<FilterSection> sections;

    /// Errors: of `checkedGains`.
    static Result<ShapedEquation> make(const ShapedLaw& law, double period_s);
};

/// The difference equation of a law, one call a sample, from rest at zero. The computing delay of the loop is
/// not in it. `Value` is a number, or an Eigen array of numbers for as many motors in step.
template <typename Value>
class ShapedRun {
public:
    ShapedRun(ShapedEquation equation, const Value& zero)
        : m_equation(std::move(equation)), m_memories(m_equation.sections.size(), Memory{zero, zero}),
          m_integral_A(zero), m_rate_rad_s(zero), m_lastWeighted_rad(zero) {}

    /// The current in A, without a limit.
    Value step(double reference_rad, const Value& angle_rad) {
        const Value current_A = demand_A(reference_rad, angle_rad);
        integrate(reference_rad - angle_rad);
        return current_A;
    }

    /// The two halves of a step: whoever limits the current decides between them whether the integral goes
    /// on.
    Value demand_A(double reference_rad, const Value& angle_rad) {
        const PidGains& gains = m_equation.gains;
        const double filter_s = gains.filter_s.value_or(0.0);
        const Value weighted_rad = m_equation.derivativeWeight * reference_rad - angle_rad;
        const double perSpan_1_s = 1.0 / (m_equation.period_s + filter_s); // lanes divide slowly
        m_rate_rad_s = perSpan_1_s * (filter_s * m_rate_rad_s + (weighted_rad - m_lastWeighted_rad));
        m_lastWeighted_rad = weighted_rad;
        Value current_A = gains.proportional * (m_equation.proportionalWeight * reference_rad - angle_rad) +
                          m_integral_A + gains.derivative * m_rate_rad_s;
        for (std::size_t i = 0; i < m_memories.size(); ++i) {
            current_A = filtered(m_equation.sections[i], m_memories[i], current_A);
        }
        return current_A;
    }
    void integrate(const Value& error_rad) {
        m_integral_A += m_equation.period_s * m_equation.gains.integral * error_rad;
    }

private:
    /// In the transposed direct form: its two numbers stay small where the filter is slow.
    struct Memory {
        Value first;
        Value second;
    };

    static Value filtered(const FilterSection& section, Memory& memory, const Value& input_A) {
        const Value output_A = section.b0 * input_A + memory.first;
        memory.first = section.b1 * input_A - section.a1 * output_A + memory.second;
        memory.second = section.b2 * input_A - section.a2 * output_A;
        return output_A;
    }

    ShapedEquation m_equation;
    std::vector<Memory> m_memories; ///< of each section
    Value m_integral_A;
    Value m_rate_rad_s;
    Value m_lastWeighted_rad;
};

/// The law of one motor.
class ShapedController : public ShapedRun<double> {
public:
    /// Errors: of `checkedGains`.
    static Result<ShapedController> make(const ShapedLaw& law, double period_s);

private:
    explicit ShapedController(ShapedEquation equation) : ShapedRun(std::move(equation), 0.0) {}
};

} // namespace halbench::control
