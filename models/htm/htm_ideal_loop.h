#pragma once

#include "control/assess/loop_reference.h"
#include "control/law/board_law.h"
#include "models/htm/htm_rotor.h"

#include <functional>
#include <vector>

namespace halbench::models {

/// The presets of resources/help/htm-theory.md section 8. The recommended one takes its feed-forward from the
/// motor's J, c, K_f, phi.
control::SampledPositionLaw publishedLaw();
control::SampledPositionLaw microStepLaw();
control::SampledPositionLaw publishedInDegreesLaw();
control::SampledPositionLaw recommendedLaw(const RotorConfig& rotor, double torqueConstant_Nm_per_A);

/// Level A of section 8: exact angle, torque = phi I held over each period, nothing between loop and rotor.
struct IdealLoopConfig {
    RotorConfig rotor;
    double torqueConstant_Nm_per_A = 1.43e-2;
    control::SampledPositionLaw law;
    control::LoopReference reference; ///< relative to the initial angle
    double initialAngle_rad = 0.0;
    double duration_s = 3.0;
    int subStepsPerMillisecond = 1;
    /// In the place of `law`, of which the period stays: called once a period, it answers the current that
    /// flows from there on. Angles are relative to the initial one.
    std::function<double(const control::ReferencePoint& reference, double angle_rad)> controller = {};
};

/// A rotor at rest at 0 rad with torque = phi I, as the plant of control::replayLoop(): each one begins anew.
/// `friction_ratio`: of this run over K_f.
std::function<double(double current_A, double duration_s)>
rotorAtRest(const RotorConfig& rotor, double torqueConstant_Nm_per_A, double friction_ratio = 1.0);

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
