#include "app/procedures/frequency/frequency_plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace halbench::app {
namespace {

// The base is moved so that the turn's harmonics fall between the lines: by up to a turn in a period, which
// is short for high frequencies. Half of the speed limit, 20 rad/s, is all the same the most.
TEST(FrequencyPlan, theBaseIsNeverFasterThanHalfTheSpeedLimit) {
    FrequencyMargins motor;
    motor.law.kp_A_per_rad = 10.0;
    motor.law.ki_A_per_rad_s = 0.1;
    motor.law.limit_A = 4.0;
    motor.plant = {2.236, 26.0, 1.434}; // resources/help/htm-theory.md section 2
    FrequencyConfig config;
    config.to_Hz = 45.0;
    for (const auto& [from_Hz, base_rad_s] :
         {std::pair{1.0, 3.0}, {5.0, 5.0}, {20.0, 13.0}, {25.0, 20.0}, {2.0, 19.9}}) {
        config.from_Hz = from_Hz;
        config.base_rad_s = base_rad_s;
        const auto plan = planFrequency(config, motor);
        if (plan) {
            EXPECT_LE(plan->turn_rad_s, 0.5 * config.speedLimit_rad_s) << from_Hz;
            EXPECT_GE(plan->turn_rad_s, 3.0) << from_Hz;
        } else {
            EXPECT_NE(plan.error().hint.find("smaller lowest frequency"), std::string::npos) << from_Hz;
        }
    }
    config.from_Hz = 20.0; // 0.2 s: 0.382 turns in it are 12.0 rad/s, 1.382 turns 43.4
    config.base_rad_s = 13.0;
    const auto below = planFrequency(config, motor);
    ASSERT_TRUE(below) << below.error().message;
    EXPECT_NEAR(below->turn_rad_s, 2.0 * M_PI * 0.382 / 0.2, 1e-9);
}

} // namespace
} // namespace halbench::app
