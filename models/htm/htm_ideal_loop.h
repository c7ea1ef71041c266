#pragma once

#include "models/htm/htm_rotor.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace halbench::models {

/// A position reference that starts at t = 0: the shapes of the board's generator that have an ideal
/// prediction, in rad. staircase: amplitude (1 + floor(t/period)), at most `count` steps.
struct LoopReference {
    enum class Shape { Step, Ramp, Sine, Staircase };
    Shape shape = Shape::Step;
    double amplitude_rad = 0.0;
    double rate_rad_s = 0.0; ///< ramp; held at |amplitude| when that is not zero, as on the board
    double frequency_Hz = 0.0;
    double period_s = 1.0;
    int count = 1;
};

struct ReferencePoint {
    double value_rad = 0.0;
    double speed_rad_s = 0.0;
    double acceleration_rad_s2 = 0.0;
};

ReferencePoint evaluateReference(const LoopReference& reference, double time_s);

/// The position law of the board in double precision (resources/help/htm-theory.md sections 3.6, 8.4):
///   u = Kp e + x + Kd (r' - (psi[k] - psi[k-1])/Ts) + inertia r'' + viscous r' + coulomb
///   sat(r'/coulombSpeed)
///       + (|r'| < stictionSpeed and |e| > stictionThreshold) stiction sgn(e)
///   u_sat = clamp(u);   if (u = u_sat or e u < 0)  x <- x + Ts Ki e
struct PositionLaw {
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

/// The presets of resources/help/htm-theory.md section 8. The recommended one takes its feed-forward from the
/// motor's J, c, K_f, phi.
PositionLaw publishedLaw();
PositionLaw microStepLaw();
PositionLaw publishedInDegreesLaw();
PositionLaw recommendedLaw(const RotorConfig& rotor, double torqueConstant_Nm_per_A);

/// Level A of section 8: exact angle, torque = phi I held over each period, nothing between loop and rotor.
struct IdealLoopConfig {
    RotorConfig rotor;
    double torqueConstant_Nm_per_A = 1.43e-2;
    PositionLaw law;
    LoopReference reference; ///< relative to the initial angle
    double initialAngle_rad = 0.0;
    double duration_s = 3.0;
    int subStepsPerMillisecond = 1;
    /// In the place of `law`, of which the period stays: called once a period, it answers the current that
    /// flows from there on. Angles are relative to the initial one.
    std::function<double(const ReferencePoint& reference, double angle_rad)> controller = {};
};

/// At the instants of LoopRows, to the duration: angles relative to the start, the current held thereafter.
struct IdealTrace {
    std::vector<double> time_s;
    std::vector<double> angle_rad;
    std::vector<double> speed_rad_s;
    std::vector<double> reference_rad;
    std::vector<double> current_A;
};

/// Deterministic; 1 s of motor time takes about 0.1 ms.
IdealTrace runIdealLoop(const IdealLoopConfig& config);

} // namespace halbench::models
