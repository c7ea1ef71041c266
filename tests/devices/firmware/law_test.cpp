#include "devices/firmware/control/hb_law.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace {

constexpr double Pi = std::numbers::pi;
constexpr double Degree = Pi / 180.0;

hb_law_config published() {
    hb_law_config config{};
    for (hb_law_section& section : config.sections) {
        section.b0 = 1.0F;
    }
    config.kp_A_per_rad = 10.0F;
    config.ki_A_per_rad_s = 0.1F;
    config.reference_weight = 1.0F;
    config.coulomb_speed_rad_s = 0.02F;
    config.limit_A = 4.0F;
    config.period_s = 0.01F;
    return config;
}

float step(hb_law& law, const hb_law_config& config, float reference, float position, float speed = 0.0F,
           float acceleration = 0.0F) {
    const hb_law_input input{position, reference, speed, acceleration, 0};
    return hb_law_step(&law, &config, &input);
}

TEST(Law, integratesWithOneSampleOfHoldAsTheZeroOrderHoldForm) {
    // C(z) = Kp + Ts Ki z^-1/(1 - z^-1): the integral starts to act one sample after the error.
    hb_law_config config = published();
    config.ki_A_per_rad_s = 50.0F;
    hb_law law{};
    EXPECT_FLOAT_EQ(step(law, config, 0.1F, 0.0F), 1.0F);
    EXPECT_FLOAT_EQ(step(law, config, 0.1F, 0.0F), 1.0F + 0.01F * 50.0F * 0.1F);
    EXPECT_FLOAT_EQ(step(law, config, 0.0F, 0.0F), 2 * 0.01F * 50.0F * 0.1F);
}

TEST(Law, stopsIntegratingWhileSaturated) {
    hb_law_config config = published();
    config.ki_A_per_rad_s = 50.0F;
    hb_law law{};
    for (int i = 0; i < 1000; ++i) {
        ASSERT_EQ(step(law, config, 1.0F, 0.0F), 4.0F);
    }
    EXPECT_EQ(law.integral_A, 0.0F);
    EXPECT_FLOAT_EQ(step(law, config, 0.0F, 0.0F), 0.0F);
}

TEST(Law, letsTheIntegralLeaveSaturation) {
    // Saturated high with a negative error (e u < 0): the integral runs down although u is clamped.
    hb_law_config config = published();
    config.ki_A_per_rad_s = 50.0F;
    hb_law law{};
    law.integral_A = 8.0F;
    EXPECT_EQ(step(law, config, -0.1F, 0.0F), 4.0F);
    EXPECT_FLOAT_EQ(law.integral_A, 8.0F - 0.01F * 50.0F * 0.1F);
}

TEST(Law, addsDerivativeFeedForwardAndFrictionHelp) {
    // resources/help/htm-theory.md 8.4, preset "recommended" with J/phi, c/phi, 0.9 K_f/phi of its table 2
    hb_law_config config = published();
    config.kp_A_per_rad = 40.0F;
    config.ki_A_per_rad_s = 60.0F;
    config.kd_As_per_rad = 1.4F;
    config.inertia_As2_per_rad = static_cast<float>(5.5e-4 / 1.43e-2);
    config.viscous_As_per_rad = static_cast<float>(1.23e-3 / 1.43e-2);
    config.coulomb_A = config.stiction_A = static_cast<float>(0.9 * 2.05e-2 / 1.43e-2);
    config.stiction_threshold_rad = static_cast<float>(0.16 * Degree);
    config.stiction_speed_rad_s = 0.02F;
    hb_law law{};
    step(law, config, 0.0F, 0.0F); // the position of the sample before: 0
    const double expected =
        40 * 0.005 + 1.4 * (0.5 - 0.005 / 0.01) + (5.5e-4 * 2.0 + 1.23e-3 * 0.5 + 0.9 * 2.05e-2) / 1.43e-2;
    EXPECT_NEAR(static_cast<double>(step(law, config, 0.010F, 0.005F, 0.5F, 2.0F)), expected, 2e-5);
    hb_law rest{};
    EXPECT_NEAR(static_cast<double>(step(rest, config, 0.003F, 0.0F)), 40 * 0.003 + 0.9 * 2.05e-2 / 1.43e-2,
                1e-5);
    hb_law below{};
    EXPECT_NEAR(static_cast<double>(step(below, config, -0.0025F, 0.0F)), -40 * 0.0025,
                1e-5); // 0.143 deg: no help
}

TEST(Law, smoothsTheCoulombSignOfSlowReferences) {
    hb_law_config config = published();
    config.coulomb_A = 1.0F;
    hb_law law{};
    EXPECT_FLOAT_EQ(step(law, config, 0.0F, 0.0F, 0.01F), 0.5F);
    EXPECT_FLOAT_EQ(step(law, config, 0.0F, 0.0F, -5.0F), -1.0F);
    EXPECT_FLOAT_EQ(step(law, config, 0.0F, 0.0F, 0.0F), 0.0F);
}

TEST(Law, delaysItsCommandByWholeSamples) {
    for (int delay = 0; delay <= 2; ++delay) {
        hb_law_config config = published();
        config.ki_A_per_rad_s = 0.0F;
        config.delay_samples = static_cast<std::uint8_t>(delay);
        hb_law law{};
        for (int k = 0; k < 10; ++k) {
            const float error = 0.01F * static_cast<float>(k + 1);
            const int source = k - delay;
            const double expected = source < 0 ? 0.0 : 10.0 * 0.01 * (source + 1);
            EXPECT_NEAR(static_cast<double>(step(law, config, error, 0.0F)), expected, 1e-6);
        }
    }
}

TEST(Law, isProportionalPlusAConstantInItsLiteralForm) {
    // resources/help/htm-theory.md 6.6: i[k] = 10 e[k] - 10 e[k-1] + i[k-1] has no integrator.
    hb_law_config config = published();
    config.law = HB_LAW_LITERAL;
    hb_law law{};
    for (int k = 0; k < 500; ++k) {
        EXPECT_NEAR(static_cast<double>(step(law, config, 0.2F, 0.0F)), 2.0, 1e-5);
    }
    EXPECT_EQ(step(law, config, 3.0F, 0.0F), 4.0F);
    EXPECT_NEAR(static_cast<double>(step(law, config, 0.1F, 0.0F)), 1.0, 1e-5);
    hb_law clamped{};
    config.law = HB_LAW_LITERAL_CLAMPED;
    EXPECT_EQ(step(clamped, config, 3.0F, 0.0F), 4.0F);
    EXPECT_EQ(step(clamped, config, 0.1F, 0.0F), -4.0F); // 4 + 10 (0.1 - 3.0) = -25, clamped
}

// The ideal loop of resources/help/htm-theory.md 8.1: exact angle, torque = phi I, closed-form motion between
// samples.
constexpr double Inertia = 5.5e-4, Damping = 1.23e-3, Friction = 2.05e-2, Torque = 1.43e-2;

struct Rotor {
    double angle = 0.0, speed = 0.0;
};

void move(Rotor& rotor, double torque, double duration) {
    const double a = Damping / Inertia;
    while (duration > 0.0) {
        if (rotor.speed == 0.0 && std::abs(torque) <= Friction) {
            return;
        }
        const double sign = rotor.speed != 0.0 ? std::copysign(1.0, rotor.speed) : std::copysign(1.0, torque);
        const double end = (torque - sign * Friction) / Damping;
        const bool stops = sign * rotor.speed > 0.0 && sign * end < 0.0;
        const double crossing = stops ? std::log((rotor.speed - end) / -end) / a : duration;
        const double t = std::min(duration, crossing);
        const double decay = std::exp(-a * t);
        rotor.angle += end * t + (rotor.speed - end) * (1.0 - decay) / a;
        rotor.speed = stops && crossing <= duration ? 0.0 : end + (rotor.speed - end) * decay;
        duration -= t;
    }
}

struct StepResponse {
    double overshoot_percent, peak_s, rise_s, final_deg;
};

StepResponse stepResponse(const hb_law_config& config, double amplitude_deg) {
    Rotor rotor;
    hb_law law{};
    double peak = 0.0;
    StepResponse result{};
    double at10 = -1.0, at90 = -1.0;
    float current = 0.0F;
    for (int ms = 0; ms < 4000; ++ms) {
        if (ms % 10 == 0) {
            current = step(law, config, static_cast<float>(amplitude_deg * Degree),
                           static_cast<float>(rotor.angle));
        }
        move(rotor, Torque * static_cast<double>(current), 1e-3);
        const double part = rotor.angle / Degree / amplitude_deg;
        const double t = (ms + 1) * 1e-3;
        if (at10 < 0 && part >= 0.1) {
            at10 = t;
        }
        if (at90 < 0 && part >= 0.9) {
            at90 = t;
        }
        if (part > peak) {
            peak = part;
            result.peak_s = t;
        }
    }
    result.overshoot_percent = (peak - 1.0) * 100.0;
    result.rise_s = at90 - at10;
    result.final_deg = rotor.angle / Degree;
    return result;
}

TEST(LawInTheLoop, reproducesThePublishedSteps) {
    const struct {
        double amplitude_deg, rise_s, overshoot_percent, peak_s, error_deg;
    } rows[] = {
        {100, 0.162, 33.3, 0.342, 4.59}, {180, 0.226, 27.9, 0.455, -2.09}, {300, 0.305, 22.9, 0.590, -7.08}};
    for (const auto& row : rows) {
        const StepResponse response = stepResponse(published(), row.amplitude_deg);
        // Tolerances of section 8: 0.002 s, 0.3 points, 0.25 deg; the peak time on a 1 ms grid likewise.
        EXPECT_NEAR(response.rise_s, row.rise_s, 0.002);
        EXPECT_NEAR(response.overshoot_percent, row.overshoot_percent, 0.3);
        EXPECT_NEAR(response.peak_s, row.peak_s, 0.002);
        EXPECT_NEAR(row.amplitude_deg - response.final_deg, row.error_deg, 0.25);
    }
}

TEST(LawInTheLoop, mirrorsTheStepExactly) {
    const StepResponse up = stepResponse(published(), 100.0);
    const StepResponse down = stepResponse(published(), -100.0);
    EXPECT_EQ(up.final_deg, -down.final_deg);
    EXPECT_EQ(up.overshoot_percent, down.overshoot_percent);
}

TEST(LawInTheLoop, stopsShortWithTheLiteralEquationAndClampedMemory) {
    // resources/help/htm-theory.md 6.6: 28.1 deg instead of 95.4 deg
    hb_law_config config = published();
    config.law = HB_LAW_LITERAL_CLAMPED;
    EXPECT_NEAR(stepResponse(config, 100.0).final_deg, 28.1, 0.25);
    EXPECT_NEAR(stepResponse(published(), 100.0).final_deg, 95.4, 0.25);
}

} // namespace
