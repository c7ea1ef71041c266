#include "models/planar/current_source.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::models {
namespace {

/// Second route: the two laws by Euler's method in steps of 2 ns; error about w h/2 = 4e-5 of the change.
SourceCurrent integrated(const CurrentSourceConfig& config, double current_A, double demand_A, double R_Ohm,
                         double induced_V, double step_s) {
    const int count = static_cast<int>(step_s / 2e-9);
    const double h = step_s / count;
    const double target_A =
        std::clamp(demand_A, -config.limit_A, config.limit_A) - induced_V / config.output_Ohm;
    double sum = 0.0;
    for (int i = 0; i < count; ++i) {
        const double wanted_V = config.inductance_H * config.bandwidth_rad_s * (target_A - current_A) +
                                R_Ohm * current_A + induced_V;
        const double voltage_V = std::clamp(wanted_V, -config.supply_V, config.supply_V);
        const double next_A =
            current_A + h * (voltage_V - R_Ohm * current_A - induced_V) / config.inductance_H;
        sum += 0.5 * (current_A + next_A) * h;
        current_A = next_A;
    }
    return {current_A, sum / step_s};
}

TEST(CurrentSource, followsASmallStepWithItsBandwidth) {
    const CurrentSourceConfig config;
    const double tau_s = 1.0 / config.bandwidth_rad_s;
    EXPECT_NEAR(tau_s, 23.1e-6, 0.05e-6); // theory section 8
    const SourceCurrent current = stepCurrentSource(config, 0.0, 0.1, 1.98, 0.0, tau_s);
    EXPECT_NEAR(current.atEnd_A, 0.1 * (1.0 - std::exp(-1.0)), 1e-15);
    EXPECT_NEAR(current.mean_A, 0.1 * std::exp(-1.0), 1e-15); // 1 - (1 - 1/e)
}

TEST(CurrentSource, integratesBothLawsExactly) {
    CurrentSourceConfig config;
    for (const double supply_V : {5.0, 24.0, 100.0}) {
        config.supply_V = supply_V;
        for (const double demand_A : {-0.9, 0.2, 0.7, 3.0}) {
            for (const double induced_V : {-0.6, 0.0, 0.4}) {
                const SourceCurrent exact = stepCurrentSource(config, -0.4, demand_A, 2.1, induced_V, 2e-4);
                const SourceCurrent summed = integrated(config, -0.4, demand_A, 2.1, induced_V, 2e-4);
                EXPECT_NEAR(exact.atEnd_A, summed.atEnd_A, 2e-4);
                EXPECT_NEAR(exact.mean_A, summed.mean_A, 2e-4);
            }
        }
    }
}

TEST(CurrentSource, settlesAtTheLimitLessTheShareOfTheInducedVoltage) {
    const CurrentSourceConfig config;
    const SourceCurrent current = stepCurrentSource(config, 0.0, 2.0, 1.98, 0.5, 0.1);
    EXPECT_NEAR(current.atEnd_A, 1.0 - 0.5 / 2e3, 1e-14);
}

TEST(CurrentSource, supplyLimitsTheCurrentThatAColdCoilCanReach) {
    CurrentSourceConfig config;
    config.supply_V = 1.5;
    const SourceCurrent current = stepCurrentSource(config, 0.0, 1.0, 2.0, 0.5, 10.0);
    EXPECT_NEAR(current.atEnd_A, (1.5 - 0.5) / 2.0, 1e-12);
}

} // namespace
} // namespace halbench::models
