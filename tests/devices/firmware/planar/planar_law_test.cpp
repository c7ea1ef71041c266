#include "tests/devices/firmware/planar/planar_board.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

// The axes run the one position law (hb_law.h), tested with it; here: that the settings of the board are the
// design of resources/help/planar-theory.md section 9.

namespace halbench::devices::firmware {
namespace {

struct Step {
    double overshoot_ratio = 0.0;
    double errorIntegral_s = 0.0; ///< of the error over the step, per unit of the step
};

hb_law_config lawOf(const hb_planar_gains& gains) {
    hb_law_config config{};
    config.kp_A_per_rad = gains.kp;
    config.ki_A_per_rad_s = gains.ki;
    config.kd_As_per_rad = gains.kd;
    config.reference_weight = gains.reference_weight;
    config.derivative_reference_weight = gains.derivative_reference_weight;
    config.derivative_filter_s = gains.derivative_filter_s;
    std::copy(std::begin(gains.sections), std::end(gains.sections), std::begin(config.sections));
    config.limit_A = 1e6F;
    config.period_s = 1e-3F;
    return config;
}

/// A free mass under the law with one sample of delay, in double precision where the board is not.
Step stepOf(const hb_law_config& config, double inertia) {
    constexpr double Period_s = 1e-3;
    constexpr double Size = 1e-3;
    double position = 0.0, speed = 0.0, effort = 0.0;
    hb_law law{};
    hb_law_reset(&law);
    Step result;
    for (int k = 0; k < 10000; ++k) {
        hb_law_input input{};
        input.position_rad = static_cast<float>(position);
        input.reference_rad = static_cast<float>(Size);
        const auto next = static_cast<double>(hb_law_step(&law, &config, &input));
        result.errorIntegral_s += Period_s * (Size - position) / Size;
        result.overshoot_ratio = std::max(result.overshoot_ratio, position / Size - 1.0);
        const double acceleration = effort / inertia; // of the sample before
        position += Period_s * speed + 0.5 * Period_s * Period_s * acceleration;
        speed += Period_s * acceleration;
        effort = next;
    }
    return result;
}

TEST(PlanarLaw, hasTheErrorIntegralOfItsWeightAndNoOvershoot) {
    const hb_planar_calibration page = initialCalibration();
    const Step x = stepOf(lawOf(page.gains[0]), 0.64);
    // kp (1 - b)/ki = 0.13291 s for x and y; single precision and the last 1e-4 of the settling.
    EXPECT_NEAR(x.errorIntegral_s, 0.13291, 2e-4);
    EXPECT_LT(x.overshoot_ratio, 1e-3);
    const Step phi = stepOf(lawOf(page.gains[2]), 1e-3);
    EXPECT_NEAR(phi.errorIntegral_s, 3.864 * 0.255 / 7.92, 2e-4);
    EXPECT_LT(phi.overshoot_ratio, 1e-3);
}

TEST(PlanarLaw, overshootsWithFullWeight) {
    // b = 1: the integral of the error vanishes; 8.9 % with the derivative on the measurement.
    hb_law_config config = lawOf(initialCalibration().gains[0]);
    config.reference_weight = 1.0F;
    const Step step = stepOf(config, 0.64);
    EXPECT_NEAR(step.errorIntegral_s, 0.0, 2e-4);
    EXPECT_NEAR(step.overshoot_ratio, 0.089, 0.005);
}

TEST(PlanarLaw, derivativeFilterDecaysAsThePublishedOne) {
    // D = exp(-Ts/Tf) with Tf = 2 ms; the law's backward difference keeps Tf'/(Ts + Tf') of a sample.
    for (const hb_planar_gains& gains : initialCalibration().gains) {
        const double filter_s = static_cast<double>(gains.derivative_filter_s);
        EXPECT_NEAR(filter_s / (1e-3 + filter_s), std::exp(-0.5), 1e-6);
    }
}

} // namespace
} // namespace halbench::devices::firmware
