#include "control/assess/position_law_state.h"

#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

double sign(double value) {
    return value > 0.0 ? 1.0 : (value < 0.0 ? -1.0 : 0.0);
}

} // namespace

double PositionLawState::step(const ReferencePoint& reference, double angle_rad) {
    const double error_rad = reference.value_rad - angle_rad;
    const double now_A = m_law.form == SampledPositionLaw::Form::Positional
                             ? positional_A(reference, angle_rad, error_rad)
                             : literal_A(error_rad);
    m_previousAngle_rad = angle_rad;
    m_hasPrevious = true;
    const double output_A = m_law.delaySamples == 0   ? now_A
                            : m_law.delaySamples == 1 ? m_delayed_A[0]
                                                      : m_delayed_A[1];
    m_delayed_A = {now_A, m_delayed_A[0]};
    return output_A;
}

double PositionLawState::positional_A(const ReferencePoint& reference, double angle_rad, double error_rad) {
    const double speed_rad_s = m_hasPrevious ? (angle_rad - m_previousAngle_rad) / m_law.period_s : 0.0;
    const bool isHeld = std::fabs(reference.speed_rad_s) < m_law.stictionSpeed_rad_s &&
                        std::fabs(error_rad) > m_law.stictionThreshold_rad;
    const double u_A =
        m_law.kp_A_per_rad * error_rad + m_integral_A +
        m_law.kd_As_per_rad * (reference.speed_rad_s - speed_rad_s) +
        m_law.inertia_As2_per_rad * reference.acceleration_rad_s2 +
        m_law.viscous_As_per_rad * reference.speed_rad_s +
        m_law.coulomb_A * std::clamp(reference.speed_rad_s / m_law.coulombSpeed_rad_s, -1.0, 1.0) +
        (isHeld ? m_law.stiction_A * sign(error_rad) : 0.0);
    const double limited_A = std::clamp(u_A, -m_law.limit_A, m_law.limit_A);
    if (u_A == limited_A || error_rad * u_A < 0.0) {
        m_integral_A += m_law.period_s * m_law.ki_A_per_rad_s * error_rad;
    }
    return limited_A;
}

// i[k] = Kp e[k] - Kp e[k-1] + i[k-1]: no integrator, a constant set by history.
double PositionLawState::literal_A(double error_rad) {
    m_memory_A += m_law.kp_A_per_rad * (error_rad - m_previousError_rad);
    m_previousError_rad = error_rad;
    const double limited_A = std::clamp(m_memory_A, -m_law.limit_A, m_law.limit_A);
    if (m_law.form == SampledPositionLaw::Form::LiteralClampedMemory) {
        m_memory_A = limited_A;
    }
    return limited_A;
}

} // namespace halbench::control
