#pragma once

#include "control/law/board_law.h"
#include "control/law/law_run.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace halbench::control {

/// The law of a board as it runs, one call a sample, from rest at zero:
///     u = v + inertia r'' + viscous r' + coulomb sat(r'/coulombSpeed)
///           + (|r'| < stictionSpeed and |e| > stictionThreshold) stiction sgn(e),   e = r - y
///     u_sat = clamp(u);   if ((u = u_sat and the actuator has room) or e u < 0)  x <- x + T_s K_I e
/// with v of `LawRun`. In single precision it agrees with the board's C to the bit.
/// Precondition: period, limit and coulombSpeed are positive, the delay is not negative.
template <typename Number>
class BoardLawRun {
public:
    using Form = typename BoardLaw<Number>::Form;

    explicit BoardLawRun(const BoardLaw<Number>& law)
        : m_law(law), m_linear(law.equation(), Number(0)),
          m_delayed_A(static_cast<std::size_t>(law.delaySamples), Number(0)) {}

    void restAt(Number reference_rad, Number angle_rad) { m_linear.restAt(reference_rad, angle_rad); }

    /// The current in A that flows from this sample on, delayed as the law says.
    Number step(const LawReference<Number>& reference, Number angle_rad, bool isSaturated = false) {
        const Number error_rad = reference.value_rad - angle_rad;
        const Number now_A = m_law.form == Form::Positional ? positional_A(reference, angle_rad, isSaturated)
                                                            : literal_A(error_rad);
        if (m_delayed_A.empty()) {
            return now_A;
        }
        const Number output_A = std::exchange(m_delayed_A[m_oldest], now_A);
        m_oldest = (m_oldest + 1) % m_delayed_A.size();
        return output_A;
    }

private:
    Number limited_A(Number demand_A) const { return std::clamp(demand_A, -m_law.limit_A, m_law.limit_A); }

    /// The sign with a linear transition; without one a plain sign.
    Number coulombShare(Number speed_rad_s) const {
        if (speed_rad_s == Number(0)) {
            return Number(0);
        }
        if (std::abs(speed_rad_s) >= m_law.coulombSpeed_rad_s) {
            return std::copysign(Number(1), speed_rad_s);
        }
        return speed_rad_s / m_law.coulombSpeed_rad_s;
    }
    Number feedForward_A(const LawReference<Number>& reference) const {
        return m_law.inertia_As2_per_rad * reference.acceleration_rad_s2 +
               m_law.viscous_As_per_rad * reference.speed_rad_s +
               m_law.coulomb_A * coulombShare(reference.speed_rad_s);
    }
    Number stiction_A(const LawReference<Number>& reference, Number error_rad) const {
        const bool isHeld = std::abs(reference.speed_rad_s) < m_law.stictionSpeed_rad_s &&
                            std::abs(error_rad) > m_law.stictionThreshold_rad;
        return isHeld ? std::copysign(m_law.stiction_A, error_rad) : Number(0);
    }

    Number positional_A(const LawReference<Number>& reference, Number angle_rad, bool isSaturated) {
        const Number error_rad = reference.value_rad - angle_rad;
        const Number linear_A = m_linear.demand(reference.value_rad, reference.speed_rad_s, angle_rad);
        const Number demand_A = linear_A + feedForward_A(reference) + stiction_A(reference, error_rad);
        const Number command_A = limited_A(demand_A);
        if ((command_A == demand_A && !isSaturated) || error_rad * demand_A < Number(0)) {
            m_linear.integrate(error_rad);
        }
        return command_A;
    }
    /// i[k] = K_P e[k] - K_P e[k-1] + i[k-1] as printed: no integrator is left in it.
    Number literal_A(Number error_rad) {
        m_memory_A += m_law.kp_A_per_rad * (error_rad - m_lastError_rad);
        m_lastError_rad = error_rad;
        const Number command_A = limited_A(m_memory_A);
        if (m_law.form == Form::LiteralClampedMemory) {
            m_memory_A = command_A;
        }
        return command_A;
    }

    BoardLaw<Number> m_law;
    LawRun<Number, Number> m_linear;
    Number m_lastError_rad = Number(0);
    Number m_memory_A = Number(0);
    std::vector<Number> m_delayed_A; ///< a ring
    std::size_t m_oldest = 0;
};

} // namespace halbench::control
