#include "app/procedures/tune/large_step.h"

#include "control/law/board_gains.h"
#include "control/law/board_law.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::app {

Result<control::SampledPositionLaw> simulatedLaw(const LoopLaw& law, const LoopConditions& conditions) {
    const auto checked =
        law.filtered ? Result<control::PidGains>(law.filtered->gains) : control::boardGains(law.law.gains);
    if (!checked) {
        return failure(checked.error());
    }
    control::FilteredLaw filtered = asFiltered(law);
    filtered.gains = *checked;
    return control::boardLaw(filtered, law.law, conditions.timing, conditions.currentLimit_A);
}

Result<LargeStep> predictLargeStep(const control::PositionPlant& plant, const LoopLaw& law,
                                   const LoopConditions& conditions, double amplitude_rad,
                                   double duration_s) {
    const auto simulated = simulatedLaw(law, conditions);
    if (!simulated) {
        return failure(simulated.error());
    }
    constexpr double ShortestPeriod_s = 1e-5; // two million rows in 20 s
    if (conditions.timing.period_s < ShortestPeriod_s) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("a step of {:.0f} s cannot be simulated with a sampling period of {} s",
                                   duration_s, conditions.timing.period_s),
                       fmt::format("give a period of {} s or more", ShortestPeriod_s));
    }
    // Motion depends on the ratios alone, so the motor may as well have an inertia of 1.
    models::IdealLoopConfig config;
    config.rotor.inertia_kg_m2 = 1.0;
    config.rotor.viscousDamping_Nm_s = plant.dampingRate_1_s;
    config.rotor.coulombFriction_Nm = plant.breakawayCurrent_A * plant.accelerationGain_rad_s2_A;
    config.torqueConstant_Nm_per_A = plant.accelerationGain_rad_s2_A;
    config.law = *simulated;
    config.reference.amplitude_rad = amplitude_rad;
    config.duration_s = duration_s;
    models::IdealTrace trace = models::runIdealLoop(config);
    const auto metrics = control::measureStep(trace.time_s, trace.angle_rad, 0.0, amplitude_rad);
    if (!metrics) {
        return failure(metrics.error());
    }
    return LargeStep{amplitude_rad, *metrics, std::move(trace)};
}

Result<LargeStep> predictLargeStep(const control::PositionPlant& plant, const LoopLaw& law,
                                   const LoopConditions& conditions, double amplitude_rad) {
    constexpr double Usual_s = 5.0;
    constexpr double Longest_s = 20.0;
    auto step = predictLargeStep(plant, law, conditions, amplitude_rad, Usual_s);
    return step && !step->hasArrived() ? predictLargeStep(plant, law, conditions, amplitude_rad, Longest_s)
                                       : step;
}

bool LargeStep::hasArrived() const {
    const double near_rad = (1.0 - control::StepThresholds().settlingBand_ratio) * std::abs(amplitude_rad);
    return std::any_of(trace.angle_rad.begin(), trace.angle_rad.end(), [&](double angle_rad) {
        return std::copysign(1.0, amplitude_rad) * angle_rad >= near_rad;
    });
}

std::optional<double> LargeStep::overshoot_percent() const {
    return hasArrived() ? std::optional(metrics.overshoot_percent) : std::nullopt;
}

} // namespace halbench::app
