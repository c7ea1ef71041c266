#pragma once

#include "app/procedures/calibrate/calibrate_procedure.h"
#include "app/procedures/relay/relay_procedure.h"
#include "control/analysis/margins.h"
#include "control/lti/discretize.h"
#include "tests/app/procedures/simulated_motor.h"

namespace halbench::app {

inline constexpr double RelayPeriod_s = 0.01;

/// Gain margin of proportional control of 1 A/rad on the published motor behind its amplifier
/// (resources/help/htm-theory.md 2, 3.2), the current held: by the state space, another route than that of
/// the program.
inline double trueUltimateGain(int delay_samples) {
    const auto time = control::TimeBase::continuous();
    const auto rotor =
        control::TransferFunction::make({1.43e-2 / 5.5e-4}, {1.0, 1.23e-3 / 5.5e-4, 0.0}, time);
    const auto amplifier = control::TransferFunction::make({1.0}, {1.52e-8, 3.0e-4, 1.0}, time);
    auto loop =
        *control::discretize(*control::series(*rotor, *amplifier), RelayPeriod_s, control::Hold::Zoh{});
    const auto late =
        control::TransferFunction::make({1.0}, {1.0, 0.0}, control::TimeBase::sampled(RelayPeriod_s));
    for (int i = 0; i < delay_samples; ++i) {
        loop = *control::series(loop, *late);
    }
    return control::smallestMargins(loop).gainMargin_ratio;
}

inline RelayResult measured(devices::Device& device, const RelayConfig& config) {
    const auto result = runRelay(device, config, {});
    EXPECT_TRUE(result) << result.error().message << " " << result.error().hint;
    return result ? *result : RelayResult{};
}

inline void calibrated(devices::Device& device) {
    CalibrateConfig config;
    config.apply = true;
    const auto result = runCalibrate(device, config, {});
    ASSERT_TRUE(result) << result.error().message;
}

inline bool holds(const RelayResult& result, double expected) {
    return result.ultimate && result.ultimate->gain95.first <= expected &&
           expected <= result.ultimate->gain95.second;
}

} // namespace halbench::app
