#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace halbench::control {

/// A second-order section in the shift d = z - 1, in which slow filters keep their digits in single
/// precision: (b0 d^2 + b1 d + b2)/(d^2 + a1 d + a2). Without a1 it has no memory, and b0 alone counts.
template <typename Number>
struct LawSection {
    Number b0 = Number(1);
    Number b1 = Number(0);
    Number b2 = Number(0);
    Number a1 = Number(0);
    Number a2 = Number(0);

    bool operator==(const LawSection&) const = default;
};

/// Numbers of the linear part of the position law, SI of its axis (here rad and A).
template <typename Number>
struct LawEquation {
    Number proportional = Number(0);
    Number integral = Number(0);
    Number derivative = Number(0);
    Number proportionalWeight = Number(1); ///< b
    Number derivativeWeight = Number(0);   ///< c
    Number derivativeFilter_s = Number(0); ///< T_f
    Number period_s = Number(0);           ///< T_s
    std::vector<LawSection<Number>> sections;
};

/// The linear part of the position law, one call a sample, from rest at zero (resources/help/tuning.md,
/// "Set-point weights and filters"):
///     d = (T_f d + T_s ((1 - c) r' + (w[k] - w[k-1])/T_s))/(T_f + T_s),   w = c r - y
///     v = F [ K_P (b r - y) + x + K_D d ],   x += T_s K_I (r - y)
/// Of a smooth reference the derivative knows the speed r' whatever c is, of a jump it sees the share c. The
/// computing delay of the loop is not in it. `Value` is `Number`, or an Eigen array of numbers for as many
/// motors in step. With single numbers it does the sums of the board's law in their order, so that both
/// agree to the bit.
template <typename Value, typename Number = double>
class LawRun {
public:
    LawRun(LawEquation<Number> equation, const Value& zero)
        : m_equation(std::move(equation)), m_memories(m_equation.sections.size(), Memory{zero, zero}),
          m_integral(zero), m_rate(zero), m_lastWeighted(zero) {}

    /// As if it had rested so for long: neither was there a jump of the reference before the first sample.
    void restAt(Number reference, const Value& position) {
        m_lastWeighted = m_equation.derivativeWeight * reference - position;
    }

    /// The effort, without a limit.
    Value step(Number reference, const Value& position) {
        const Value effort = demand(reference, Number(0), position);
        integrate(reference - position);
        return effort;
    }

    /// The two halves of a step: whoever limits the effort decides between them whether the integral goes on.
    Value demand(Number reference, Number referenceSpeed, const Value& position) {
        const Value weighted = m_equation.proportionalWeight * reference - position;
        Value effort =
            m_equation.proportional * weighted + m_integral + derivative(reference, referenceSpeed, position);
        for (std::size_t i = 0; i < m_memories.size(); ++i) {
            effort = filtered(m_equation.sections[i], m_memories[i], effort);
        }
        return effort;
    }
    void integrate(const Value& error) { m_integral += m_equation.period_s * m_equation.integral * error; }

private:
    struct Memory {
        Value first;
        Value second;
    };

    /// One number is divided as the board divides it; many at once are multiplied, which is quicker.
    static Value over(const Value& value, Number divisor) {
        if constexpr (std::is_same_v<Value, Number>) {
            return value / divisor;
        } else {
            return value * (Number(1) / divisor);
        }
    }

    Value derivative(Number reference, Number referenceSpeed, const Value& position) {
        const Number weight = m_equation.derivativeWeight;
        const Number filter_s = m_equation.derivativeFilter_s;
        const Value weighted = weight * reference - position;
        const Value moved = weighted - m_lastWeighted;
        Value rate = (Number(1) - weight) * referenceSpeed + over(moved, m_equation.period_s);
        m_lastWeighted = weighted;
        if (filter_s > Number(0)) {
            rate = over(filter_s * m_rate + m_equation.period_s * rate, filter_s + m_equation.period_s);
        }
        m_rate = rate;
        return m_equation.derivative * rate;
    }

    static Value filtered(const LawSection<Number>& section, Memory& memory, const Value& input) {
        if (section.a1 == Number(0)) {
            memory.first = memory.second = Number(0) * input;
            return section.b0 * input;
        }
        const Value output = section.b0 * input + memory.first;
        memory.first += memory.second + (section.b1 * input - section.a1 * output);
        memory.second += section.b2 * input - section.a2 * output;
        return output;
    }

    LawEquation<Number> m_equation;
    std::vector<Memory> m_memories; ///< of each section
    Value m_integral;
    Value m_rate;
    Value m_lastWeighted;
};

} // namespace halbench::control
