#include "control/assess/load_step.h"
#include "control/lti/responses.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

const PositionPlant Published{1.23e-3 / 5.5e-4, 1.43e-2 / 5.5e-4, 1.43357};

PidGains gains(double integral) {
    PidGains gains;
    gains.proportional = 40.0;
    gains.integral = integral;
    gains.derivative = 1.4;
    return gains;
}

// Second route: the plant behind the loop, P/(1 + C z^-d P), as polynomials; a constant load is a held one.
TEST(LoadStep, isTheAnswerOfTheTransferFunctionFromTheLoad) {
    for (const int delay_samples : {0, 1}) {
        const LoopTiming timing{0.01, delay_samples};
        const auto step = loadStep(Published, gains(60.0), timing, 0.5, 3.0, 10);
        ASSERT_TRUE(step) << step.error().message;
        const TransferFunction plant = sampledPlant(Published, timing.period_s);
        // P/(1 + L) = (1 - L/(1 + L)) P: feedback around the plant with C z^-d = L/P.
        std::vector<double> delayed(static_cast<std::size_t>(delay_samples) + 1, 0.0);
        delayed.front() = 1.0; // z^delay
        const auto late = TransferFunction::make(Polynomial({1.0}), Polynomial(delayed), plant.timeBase());
        const auto controller = sampledController(gains(60.0), timing.period_s);
        ASSERT_TRUE(late && controller);
        const auto fromLoad = feedback(plant, *series(*controller, *late));
        ASSERT_TRUE(fromLoad);
        const auto expected = stepResponse(*fromLoad, 3.0, timing.period_s);
        ASSERT_TRUE(expected);
        // Rounding of a recurrence of order five over 300 samples.
        for (std::size_t sample = 0; sample < expected->value.size(); ++sample) {
            EXPECT_NEAR(step->angle_rad[10 * sample], 0.5 * expected->value[sample], 1e-9) << sample;
        }
    }
}

TEST(LoadStep, proportionalActionYieldsByTheLoadOverItAndIntegralActionByNothing) {
    const auto stiff = loadStep(Published, gains(0.0), {0.01, 0}, 0.5, 20.0);
    ASSERT_TRUE(stiff);
    EXPECT_NEAR(stiff->angle_rad.back(), 0.5 / 40.0, 1e-9);
    EXPECT_NEAR(stiff->final_rad, 0.5 / 40.0, 1e-15);
    EXPECT_NEAR(stiff->current_A.back(), -0.5, 1e-7); // 40 A/rad and 140 of the difference times 1e-9
    const auto integral = loadStep(Published, gains(60.0), {0.01, 0}, 0.5, 20.0);
    ASSERT_TRUE(integral);
    EXPECT_NEAR(integral->angle_rad.back(), 0.0, 1e-9);
    EXPECT_EQ(integral->final_rad, 0.0);
}

TEST(LoadStep, peakAndRecoveryAreThoseOfItsCurve) {
    const auto step = loadStep(Published, gains(60.0), {0.01, 0}, 0.5, 20.0);
    ASSERT_TRUE(step);
    EXPECT_EQ(step->peak_rad, *std::max_element(step->angle_rad.begin(), step->angle_rad.end()));
    ASSERT_TRUE(step->recoveryTime_s);
    EXPECT_GT(*step->recoveryTime_s, step->peakTime_s);
    for (std::size_t i = 0; i < step->time_s.size(); ++i) {
        if (step->time_s[i] >= *step->recoveryTime_s) {
            EXPECT_LE(std::abs(step->angle_rad[i]), 0.1 * step->peak_rad);
        }
    }
    const auto other = loadStep(Published, gains(60.0), {0.01, 0}, -1.0, 20.0); // linear
    EXPECT_NEAR(other->peak_rad, -2.0 * step->peak_rad, 1e-12);
    EXPECT_EQ(other->recoveryTime_s, step->recoveryTime_s);
    const auto early = loadStep(Published, gains(60.0), {0.01, 0}, 0.5, step->peakTime_s); // still on its way
    EXPECT_FALSE(early->recoveryTime_s);
}

TEST(LoadStep, refusesWhatIsNoLoad) {
    EXPECT_FALSE(loadStep(Published, gains(60.0), {0.01, 0}, 0.0, 1.0));
    EXPECT_FALSE(loadStep(Published, gains(60.0), {0.01, 0}, NAN, 1.0));
    EXPECT_FALSE(loadStep(Published, gains(60.0), {0.01, 0}, 0.5, -1.0));
}

} // namespace
} // namespace halbench::control
