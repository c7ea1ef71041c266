#include "app/workspaces/tune/standstill_ripple.h"
#include "control/base/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace halbench::app {
namespace {

constexpr double Period_s = 0.01;
constexpr double Noise_rad = 7.2e-4; ///< 0.041 degrees, the quantised Hall sensors (htm-theory.md 7.4)

control::PidGains recommended() {
    control::PidGains gains; // htm-theory.md 8.4
    gains.proportional = 40.0;
    gains.integral = 60.0;
    gains.derivative = 1.4;
    return gains;
}

/// A rotor at rest whose angle is measured with noise, and `factor` times the current of the law.
Recording atRest(double factor) {
    Random random(7);
    const control::PidGains gains = recommended();
    StreamLayout layout;
    layout.columns = {{"position", "rad"}, {"current_command", "A"}};
    Recording recording;
    recording.layout = std::make_shared<const StreamLayout>(layout);
    double before_rad = 0.0;
    for (int i = 0; i < 5000; ++i) {
        const double angle_rad = Noise_rad * random.gaussian();
        const double current_A =
            -gains.proportional * angle_rad - gains.derivative / Period_s * (angle_rad - before_rad);
        before_rad = angle_rad;
        recording.time_s.push_back(Period_s * i);
        recording.values.push_back(angle_rad);
        recording.values.push_back(factor * current_A);
    }
    return recording;
}

TEST(StandstillRipple, isWhatTheNoiseOfTheAngleMakesOfTheLaw) {
    const auto ripple = standstillRipple(atRest(1.0), recommended(), Period_s);
    ASSERT_TRUE(ripple);
    // Cutting 5 % at either end leaves 0.79 of a normal spread, of both; 1000 samples are good to 3 %.
    EXPECT_NEAR(ripple->angle_rad, 0.79 * Noise_rad, 0.1 * Noise_rad);
    // sqrt((K_P + K_D/T_s)^2 + (K_D/T_s)^2) = 228 A/rad: 0.164 A of the noise
    EXPECT_NEAR(ripple->current_A, 0.79 * 0.164, 0.02);
    EXPECT_NEAR(ripple->explained_A, ripple->current_A, 0.1 * ripple->current_A);
    const QString words = rippleWords(*ripple, {});
    EXPECT_TRUE(words.contains("noise of the measured angle")) << words.toStdString();
    EXPECT_TRUE(words.contains("multiplied by these gains")) << words.toStdString();
}

TEST(StandstillRipple, whatTheNoiseDoesNotExplainIsCalledSo) {
    const auto ripple = standstillRipple(atRest(3.0), recommended(), Period_s);
    ASSERT_TRUE(ripple);
    EXPECT_TRUE(rippleWords(*ripple, {}).contains("hunt"));
}

TEST(StandstillRipple, aQuietCurrentNeedsNoWord) {
    EXPECT_TRUE(rippleWords({0.01, Noise_rad, 0.01}, {}).isEmpty());
    EXPECT_FALSE(standstillRipple(Recording{}, recommended(), Period_s));
}

} // namespace
} // namespace halbench::app
