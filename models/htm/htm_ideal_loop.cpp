#include "models/htm/htm_ideal_loop.h"

#include "control/assess/loop_rows.h"
#include "control/base/assert.h"
#include "control/base/units.h"
#include "control/law/board_law_run.h"
#include "models/htm/rotor_step.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace halbench::models {
namespace {

void appendRow(IdealTrace& trace, double time_s, const RotorState& rotor, double initialAngle_rad,
               double reference_rad, double current_A) {
    trace.time_s.push_back(time_s);
    trace.angle_rad.push_back(rotor.angle_rad - initialAngle_rad);
    trace.speed_rad_s.push_back(rotor.speed_rad_s);
    trace.reference_rad.push_back(reference_rad);
    trace.current_A.push_back(current_A);
}

} // namespace

control::SampledPositionLaw publishedLaw() {
    return {};
}

control::SampledPositionLaw microStepLaw() {
    control::SampledPositionLaw law;
    law.kp_A_per_rad = 5.0 * 180.0 / Pi;
    law.ki_A_per_rad_s = 0.05 * 180.0 / Pi;
    return law;
}

control::SampledPositionLaw publishedInDegreesLaw() {
    control::SampledPositionLaw law;
    law.kp_A_per_rad = 10.0 * 180.0 / Pi;
    law.ki_A_per_rad_s = 0.1 * 180.0 / Pi;
    return law;
}

control::SampledPositionLaw recommendedLaw(const RotorConfig& rotor, double torqueConstant_Nm_per_A) {
    const double friction_A = 0.9 * rotor.coulombFriction_Nm / torqueConstant_Nm_per_A;
    control::SampledPositionLaw law;
    law.kp_A_per_rad = 40.0;
    law.ki_A_per_rad_s = 60.0;
    law.kd_As_per_rad = 1.4;
    law.inertia_As2_per_rad = rotor.inertia_kg_m2 / torqueConstant_Nm_per_A;
    law.viscous_As_per_rad = rotor.viscousDamping_Nm_s / torqueConstant_Nm_per_A;
    law.coulomb_A = friction_A;
    law.stiction_A = friction_A;
    law.stictionThreshold_rad = degreesToRadians(0.16);
    return law;
}

std::function<double(double, double)> rotorAtRest(const RotorConfig& rotor, double torqueConstant_Nm_per_A,
                                                  double friction_ratio) {
    RotorState state;
    state.friction_ratio = friction_ratio;
    std::optional<RotorStep> step; // of the duration before: a loop asks for the same one again and again
    return [rotor, torqueConstant_Nm_per_A, state, step](double current_A, double duration_s) mutable {
        if (!step || step->duration_s() != duration_s) {
            step.emplace(rotor, duration_s);
        }
        step->move(state, torqueConstant_Nm_per_A * current_A);
        return state.angle_rad;
    };
}

IdealTrace runIdealLoop(const IdealLoopConfig& config) {
    HB_ASSERT(config.subStepsPerMillisecond > 0);
    const control::LoopRows rows(config.law.period_s);
    const long last = std::lround(config.duration_s / rows.interval_s());
    control::BoardLawRun<double> law(config.law);
    const RotorStep step(config.rotor, rows.interval_s() / config.subStepsPerMillisecond);
    RotorState rotor;
    rotor.angle_rad = config.initialAngle_rad;
    double current_A = 0.0;
    IdealTrace trace;
    for (long row = 0; row <= last; ++row) {
        const double time_s = rows.time_s(row);
        const control::ReferencePoint reference = control::evaluateReference(config.reference, time_s);
        if (row % rows.perPeriod() == 0) {
            const double angle_rad = rotor.angle_rad - config.initialAngle_rad;
            current_A =
                config.controller ? config.controller(reference, angle_rad) : law.step(reference, angle_rad);
        }
        appendRow(trace, time_s, rotor, config.initialAngle_rad, reference.value_rad, current_A);
        for (int i = 0; i < config.subStepsPerMillisecond; ++i) {
            step.move(rotor, config.torqueConstant_Nm_per_A * current_A);
        }
    }
    return trace;
}

} // namespace halbench::models
