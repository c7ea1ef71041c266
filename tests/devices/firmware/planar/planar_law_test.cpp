#include "devices/firmware/planar/hb_planar_law.h"
#include "tests/devices/firmware/planar/planar_board.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

// Figures of resources/help/planar-theory.md section 9.

namespace halbench::devices::firmware {
namespace {

struct Step {
    double overshoot_ratio = 0.0;
    double errorIntegral_s = 0.0; ///< of the error over the step, per unit of the step
};

/// A free mass under the law with its filtered difference and one sample of delay, in double precision where
/// the board is not.
Step stepOf(const hb_planar_gains& gains, double inertia, double filter_s) {
    constexpr double Period_s = 1e-3;
    const double kept = std::exp(-Period_s / filter_s);
    constexpr double Size = 1e-3;
    double position = 0.0, speed = 0.0, estimate = 0.0, previous = 0.0, effort = 0.0;
    float integral = 0.0F;
    Step result;
    for (int k = 0; k < 10000; ++k) {
        estimate = kept * estimate + (1.0 - kept) * (position - previous) / Period_s;
        previous = position;
        hb_planar_law_input input{};
        input.position = static_cast<float>(position);
        input.speed = static_cast<float>(estimate);
        input.step = static_cast<float>(Size);
        const double next = static_cast<double>(
            hb_planar_law_step(&integral, &gains, &input, static_cast<float>(Period_s), 1));
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
    const Step x = stepOf(page.gains[0], 0.64, 2e-3);
    // kp (1 - b)/ki = 0.13291 s for x and y; single precision and the last 1e-4 of the settling.
    EXPECT_NEAR(x.errorIntegral_s, 0.13291, 2e-4);
    EXPECT_LT(x.overshoot_ratio, 1e-3);
    const Step phi = stepOf(page.gains[2], 1e-3, 2e-3);
    EXPECT_NEAR(phi.errorIntegral_s, 3.864 * 0.255 / 7.92, 2e-4);
    EXPECT_LT(phi.overshoot_ratio, 1e-3);
}

TEST(PlanarLaw, overshootsWithFullWeight) {
    // b = 1: the integral of the error vanishes; 8.9 % with the derivative on the measurement.
    hb_planar_gains gains = initialCalibration().gains[0];
    gains.setpoint_weight = 1.0F;
    const Step step = stepOf(gains, 0.64, 2e-3);
    EXPECT_NEAR(step.errorIntegral_s, 0.0, 2e-4);
    EXPECT_NEAR(step.overshoot_ratio, 0.089, 0.005);
}

TEST(PlanarLaw, addsWhatAProfileKnows) {
    const hb_planar_gains gains{100.0F, 10.0F, 5.0F, 0.5F, 2.0F};
    hb_planar_law_input input{};
    input.position = 0.1F;
    input.speed = 0.2F;
    input.step = 0.4F;
    input.profile = 0.3F;
    input.profile_speed = 0.6F;
    input.profile_acceleration = 0.7F;
    float integral = 1.0F;
    // 100 (0.5 0.4 + 0.3 - 0.1) + 5 (0.6 - 0.2) + 2 0.7 + 1
    EXPECT_FLOAT_EQ(hb_planar_law_step(&integral, &gains, &input, 0.001F, 1), 44.4F);
    EXPECT_FLOAT_EQ(integral, 1.0F + 10.0F * 0.001F * 0.6F);
    hb_planar_law_step(&integral, &gains, &input, 0.001F, 0);
    EXPECT_FLOAT_EQ(integral, 1.006F); // saturated: it stands still
}

} // namespace
} // namespace halbench::devices::firmware
