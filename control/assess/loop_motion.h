#pragma once

#include "control/assess/load_step.h"
#include "control/law/position_loop.h"

#include <functional>

namespace halbench::control {

// How a loop moves the exact rotor, whatever its law.

/// What sets the loop in motion: one of the two.
struct MotionCause {
    double reference_rad = 0.0;
    double load_A = 0.0; ///< beside the current of the law
};

struct LoopMotion {
    std::vector<double> time_s;
    std::vector<double> angle_rad;
    std::vector<double> current_A; ///< of the law
};

/// The current that a law demands of this reference at this angle, called once a sample; without its delay.
using SampledLaw = std::function<double(double reference_rad, double angle_rad)>;

/// From rest at zero. Errors: of the plant and the timing; OutOfRange (extent); Refused (an unstable loop
/// that grows beyond all numbers).
Result<LoopMotion> loopMotion(const PositionPlant& plant, SampledLaw law, const LoopTiming& timing,
                              const MotionCause& cause, double duration_s, int pointsPerSample);

/// The motion of a step of the reference with its figures. Errors: of measureStep.
Result<LoopStep> stepOf(LoopMotion motion, double amplitude_rad);
/// That of a load with its peak and recovery; `final_rad` is where it comes to rest.
LoadStep loadOf(LoopMotion motion, double final_rad);

} // namespace halbench::control
