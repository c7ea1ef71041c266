#include "app/procedures/large_step.h"

#include "control/design/board_gains.h"

#include <utility>

namespace halbench::app {

namespace {

models::PositionLaw boardLaw(const control::PositionLaw& law, const LoopConditions& conditions) {
    models::PositionLaw result;
    result.kp_A_per_rad = law.gains.proportional;
    result.ki_A_per_rad_s = law.gains.integral;
    result.kd_As_per_rad = law.gains.derivative;
    result.inertia_As2_per_rad = law.inertia_A_s2_rad;
    result.viscous_As_per_rad = law.viscous_A_s_rad;
    result.coulomb_A = law.coulomb_A;
    result.coulombSpeed_rad_s = law.coulombSpeed_rad_s;
    result.stiction_A = law.stictionCurrent_A;
    result.stictionThreshold_rad = law.stictionThreshold_rad;
    result.stictionSpeed_rad_s = law.stictionSpeed_rad_s;
    result.limit_A = conditions.currentLimit_A;
    result.period_s = conditions.timing.period_s;
    result.delaySamples = conditions.timing.delay_samples;
    return result;
}

} // namespace

Result<models::PositionLaw> simulatedLaw(const control::PositionLaw& law, const LoopConditions& conditions) {
    const auto gains = control::boardGains(law.gains);
    if (!gains) {
        return failure(gains.error());
    }
    control::PositionLaw converted = law;
    converted.gains = *gains;
    return boardLaw(converted, conditions);
}

Result<LargeStep> predictLargeStep(const control::PositionPlant& plant, const control::PositionLaw& law,
                                   const LoopConditions& conditions, double amplitude_rad) {
    const auto simulated = simulatedLaw(law, conditions);
    if (!simulated) {
        return failure(simulated.error());
    }
    // Motion depends on the ratios alone, so the motor may as well have an inertia of 1.
    models::IdealLoopConfig config;
    config.rotor.inertia_kg_m2 = 1.0;
    config.rotor.viscousDamping_Nm_s = plant.dampingRate_1_s;
    config.rotor.coulombFriction_Nm = plant.breakawayCurrent_A * plant.accelerationGain_rad_s2_A;
    config.torqueConstant_Nm_per_A = plant.accelerationGain_rad_s2_A;
    config.law = *simulated;
    config.reference.amplitude_rad = amplitude_rad;
    config.duration_s = 5.0;
    models::IdealTrace trace = models::runIdealLoop(config);
    const auto metrics = control::measureStep(trace.time_s, trace.angle_rad, 0.0, amplitude_rad);
    if (!metrics) {
        return failure(metrics.error());
    }
    return LargeStep{amplitude_rad, *metrics, std::move(trace)};
}

} // namespace halbench::app
