#pragma once

#include "control/assess/loop_reference.h"

#include <array>

namespace halbench::control {

/// The position law of the board in double precision (resources/help/htm-theory.md sections 3.6, 8.4):
///   u = Kp e + x + Kd (r' - (psi[k] - psi[k-1])/Ts) + inertia r'' + viscous r' + coulomb
///   sat(r'/coulombSpeed)
///       + (|r'| < stictionSpeed and |e| > stictionThreshold) stiction sgn(e)
///   u_sat = clamp(u);   if (u = u_sat or e u < 0)  x <- x + Ts Ki e
struct SampledPositionLaw {
    enum class Form { Positional, LiteralDifference, LiteralClampedMemory }; ///< the latter two: section 6.6
    Form form = Form::Positional;
    double kp_A_per_rad = 10.0;
    double ki_A_per_rad_s = 0.1;
    double kd_As_per_rad = 0.0;
    double inertia_As2_per_rad = 0.0;
    double viscous_As_per_rad = 0.0;
    double coulomb_A = 0.0;
    double coulombSpeed_rad_s = 0.02;
    double stiction_A = 0.0;
    double stictionThreshold_rad = 0.0;
    double stictionSpeed_rad_s = 0.02;
    double limit_A = 4.0;
    double period_s = 0.01;
    int delaySamples = 0;
};

/// State of the board's position law between its samples; angles from where the rotor was when the loop
/// began, at rest.
class PositionLawState {
public:
    explicit PositionLawState(const SampledPositionLaw& law) : m_law(law) {}

    /// The current that flows from this sample on. Call once a period.
    double step(const ReferencePoint& reference, double angle_rad);

private:
    double positional_A(const ReferencePoint& reference, double angle_rad, double error_rad);
    double literal_A(double error_rad);

    SampledPositionLaw m_law;
    double m_integral_A = 0.0;
    double m_previousAngle_rad = 0.0;
    double m_previousError_rad = 0.0;
    double m_memory_A = 0.0;
    std::array<double, 2> m_delayed_A{};
    bool m_hasPrevious = false;
};

} // namespace halbench::control
