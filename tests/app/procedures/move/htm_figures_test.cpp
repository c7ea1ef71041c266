#include "app/procedures/move/move_repetition.h"
#include "tests/app/procedures/simulated_motor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

// Figures of resources/help/htm-theory.md section 8 through the whole chain: plant, board, link, procedure.
// Tolerances of that section; "full chain" keeps quantisation, amplifier, noise and the compensated stray
// field.

namespace halbench::app {
namespace {

control::SampledPositionLaw recommended() {
    return models::recommendedLaw(models::RotorConfig{}, 1.43e-2);
}

double max_deg(const MoveResult& result) {
    return radiansToDegrees(result.figures().maxError);
}

double final_deg(const MoveResult& result) {
    return radiansToDegrees(result.figures().finalError);
}

struct StepCase {
    double amplitude_deg;
    double rise_s;
    double overshoot_percent;
    double peak_s;
    double final_deg;
};

class PublishedStep : public ::testing::TestWithParam<StepCase> {
protected:
    static void expectStep(const std::string& query, double overshootTolerance, double finalTolerance_deg) {
        const StepCase& expected = GetParam();
        const auto device = openMotor(query);
        const MoveResult result =
            moved(*device, move("step,amplitude_deg=" + std::to_string(expected.amplitude_deg), 6));
        ASSERT_TRUE(result.truth);
        EXPECT_NEAR(result.truth->riseTime_s.value_or(0), expected.rise_s, 0.002);
        EXPECT_NEAR(result.truth->overshoot_percent.value_or(0), expected.overshoot_percent,
                    overshootTolerance);
        EXPECT_NEAR(result.truth->peakTime_s.value_or(0), expected.peak_s, 0.002);
        EXPECT_NEAR(final_deg(result), expected.final_deg, finalTolerance_deg);
        EXPECT_EQ(result.quality.verdict, Verdict::Good);
    }
};

TEST_P(PublishedStep, throughTheIdealChainAsTheIdealLoop) {
    expectStep("chain=ideal", 0.05, 0.05); // only the board's single precision is between them
}

TEST_P(PublishedStep, throughTheFullChain) {
    expectStep(FullChain, 0.3 + 0.1, 0.25 + 0.2); // level A's own tolerance, and what the chain adds
}

INSTANTIATE_TEST_SUITE_P(Section81, PublishedStep,
                         ::testing::Values(StepCase{100, 0.162, 33.3, 0.342, 4.59},
                                           StepCase{180, 0.226, 27.9, 0.455, -2.09},
                                           StepCase{300, 0.305, 22.9, 0.590, -7.08},
                                           StepCase{-100, 0.162, 33.3, 0.342, -4.59}));

TEST(PublishedPreset, frictionlessStepOvershootsAsDerived) {
    const auto device = openMotor("chain=ideal&Kf=0");
    const MoveResult result = moved(*device, move("step,amplitude_deg=100", 6));
    EXPECT_NEAR(result.truth->overshoot_percent.value_or(0), 68.1, 0.3);
    EXPECT_NEAR(result.truth->riseTime_s.value_or(0), 0.127, 0.002);
}

TEST(PublishedPreset, rampLagsAsDerived) {
    const auto device = openMotor("chain=ideal");
    MoveConfig config = move("ramp,rate_deg_s=500", 6);
    config.evaluateFrom_s = 4.0;
    const MoveResult result = moved(*device, config);
    EXPECT_NEAR(radiansToDegrees(result.truth->peakError), 54.5, 0.3);
    EXPECT_NEAR(radiansToDegrees(result.truth->meanError), 12.0, 0.3);
}

TEST(PublishedPreset, sinesErrAsDerived) {
    const auto device = openMotor(FullChain);
    const MoveResult small = moved(*device, move("sine,amplitude_deg=360,period_s=5", 10));
    EXPECT_NEAR(radiansToDegrees(small.truth->firstSecondError), 46.6, 0.5);
    EXPECT_NEAR(max_deg(small), 19.0, 0.5);
    EXPECT_NEAR(radiansToDegrees(small.truth->rmsError), 11.1, 0.3);
    const MoveResult large = moved(*device, move("sine,amplitude_deg=500,period_s=5", 10));
    EXPECT_NEAR(radiansToDegrees(large.truth->firstSecondError), 76.2, 0.5);
    EXPECT_NEAR(max_deg(large), 21.5, 0.5);
    EXPECT_NEAR(radiansToDegrees(large.truth->rmsError), 12.4, 0.3);
}

TEST(PublishedPreset, oneHertzResponseAsDerived) {
    const auto device = openMotor("chain=ideal");
    const MoveResult result = moved(*device, move("sine,amplitude_deg=45,frequency_hz=1", 20));
    EXPECT_NEAR(result.truth->gain_ratio.value_or(0), 1.249, 0.005);
    EXPECT_NEAR(result.truth->phase_deg.value_or(0), -15.6, 0.3);
}

TEST(PublishedPreset, withoutStrayCompensationTheStepEndsShort) {
    const auto device = openMotor(FullChain);
    setParameter(*device, "stray.enabled", 0.0);
    EXPECT_NEAR(final_deg(moved(*device, move("step,amplitude_deg=100", 6))), 9.3, 0.25 + 0.2);
}

TEST(PublishedPreset, doesNotMoveASmallStep) {
    const auto device = openMotor(FullChain); // section 6.7
    const MoveResult result = moved(*device, move("step,amplitude_deg=0.32", 5));
    EXPECT_NEAR(final_deg(result), 0.32, 1e-6);
}

TEST(PublishedPreset, literalEquationWithClampedMemoryStopsFarShort) {
    const auto device = openMotor("chain=ideal"); // section 6.6: at 28.1 deg instead of 95.4
    setParameter(*device, "control.law", 2.0);
    EXPECT_NEAR(final_deg(moved(*device, move("step,amplitude_deg=100", 6))), 100 - 28.1, 0.25);
}

TEST(MicroStepPreset, followsSmallStepsAndComesToRest) {
    const auto device = openMotor(FullChain);
    setLaw(*device, models::microStepLaw());
    EXPECT_LE(max_deg(moved(*device, move("staircase,amplitude_deg=0.32,period_s=1,count=10", 10))), 0.36);
    for (const char* step : {"step,amplitude_deg=100", "step,amplitude_deg=180", "step,amplitude_deg=300"}) {
        EXPECT_LE(std::fabs(final_deg(moved(*device, move(step, 6)))), 0.3 + 0.1) << step;
    }
}

TEST(MicroStepPreset, failsWithoutStrayCompensation) {
    // Section 6.10: 286 A/rad is far above B0/k_s = 62.8 A/rad.
    const auto device = openMotor(FullChain);
    setLaw(*device, models::microStepLaw());
    setParameter(*device, "stray.enabled", 0.0);
    EXPECT_GT(max_deg(moved(*device, move("staircase,amplitude_deg=0.32,period_s=1,count=10", 10))), 0.36);
}

TEST(DegreePreset, largeStepsEndInALimitCycleFromEveryStart) {
    // Sections 6.8 and 8.3: 2.2 to 3.2 deg peak to peak in the reference, comparable statistically only
    // (section 11): the typical run of 27 starts lies in that span to half of the printed digit, so do three
    // quarters of them from below, and none is smaller than the ideal loop's 2.0.
    for (const char* step : {"step,amplitude_deg=100", "step,amplitude_deg=180", "step,amplitude_deg=300"}) {
        const auto device = openMotor(FullChain);
        setLaw(*device, models::publishedInDegreesLaw());
        MoveConfig config = move(step, 4);
        config.evaluateFrom_s = 3.0;
        const auto repeated = runRepeatedMove(*device, config, {27, degreesToRadians(0.64)}, {});
        ASSERT_TRUE(repeated) << repeated.error().message;
        EXPECT_EQ(repeated->repetition.settled_ratio(), 0.0) << step;
        std::vector<double> swing = repeated->repetition.peakToPeak;
        std::sort(swing.begin(), swing.end());
        EXPECT_GT(radiansToDegrees(swing.front()), 2.0) << step;
        EXPECT_GT(radiansToDegrees(swing[6]), 2.2 - 0.05) << step;
        EXPECT_LT(radiansToDegrees(swing[13]), 3.2 + 0.05) << step;
    }
}

TEST(DegreePreset, mostSingleMicroStepsSettle) {
    // Section 8.3: 7 of 9 starting angles in the reference; fewer than 60 % of 30 would be a chance below
    // 1 % at that rate.
    const auto device = openMotor(FullChain);
    setLaw(*device, models::publishedInDegreesLaw());
    MoveConfig config = move("step,amplitude_deg=0.32", 1);
    config.evaluateFrom_s = 0.9;
    const auto repeated = runRepeatedMove(*device, config, {30, degreesToRadians(0.28)}, {});
    ASSERT_TRUE(repeated) << repeated.error().message;
    EXPECT_GE(repeated->repetition.settled_ratio().value_or(0.0), 0.6);
}

TEST(DegreePreset, microStepsSettleFromAStartThatDoesNotFallIntoTheCycle) {
    // Section 8.3: within about 0.13 deg; which starting angles settle is chance, this one does.
    const auto device = openMotor(FullChain + "&psi0=-3.1");
    setLaw(*device, models::publishedInDegreesLaw());
    EXPECT_LE(max_deg(moved(*device, move("staircase,amplitude_deg=0.32,period_s=1,count=10", 10))), 0.28);
}

class RecommendedPreset : public ::testing::TestWithParam<double> {
protected:
    void SetUp() override {
        device = openMotor(FullChain + "&psi0=" + std::to_string(GetParam()));
        setLaw(*device, recommended());
    }
    std::unique_ptr<devices::Device> device;
};

TEST_P(RecommendedPreset, tracksSines) {
    for (const char* sine : {"sine,amplitude_deg=360,period_s=5", "sine,amplitude_deg=500,period_s=5"}) {
        const MoveResult result = moved(*device, move(sine, 10));
        EXPECT_LT(max_deg(result), 0.64) << sine;
        EXPECT_NEAR(radiansToDegrees(result.truth->rmsError), 0.16, 0.04) << sine;
    }
}

TEST_P(RecommendedPreset, tracksARamp) {
    EXPECT_LT(max_deg(moved(*device, move("ramp,rate_deg_s=500", 4))), 0.30);
}

TEST_P(RecommendedPreset, stepsWithLittleOvershootAndComesToRestThere) {
    const double overshoot_percent[] = {7.5, 9.8, 9.7};
    const char* steps[] = {"step,amplitude_deg=100", "step,amplitude_deg=180", "step,amplitude_deg=300"};
    for (int i = 0; i < 3; ++i) {
        const MoveResult result = moved(*device, move(steps[i], 3));
        EXPECT_LT(result.truth->overshoot_percent.value_or(100), 12.0) << steps[i];
        EXPECT_NEAR(result.truth->overshoot_percent.value_or(100), overshoot_percent[i], 1.0) << steps[i];
        EXPECT_LT(std::fabs(final_deg(result)), 0.32) << steps[i];
    }
}

TEST_P(RecommendedPreset, followsMicroSteps) {
    EXPECT_LT(max_deg(moved(*device, move("staircase,amplitude_deg=0.32,period_s=1,count=10", 10))), 0.25);
}

INSTANTIATE_TEST_SUITE_P(StartingAngles, RecommendedPreset, ::testing::Values(0.0, 1.0, 2.5));

TEST(RecommendedSensitivity, trueFrictionTenPercentOff) {
    // Section 8.4: 0.87 deg with 10 % more friction than the law knows, 0.15 deg with 10 % less.
    const auto more = openMotor(FullChain + "&Kf=0.02255");
    setLaw(*more, recommended());
    EXPECT_NEAR(max_deg(moved(*more, move("sine,amplitude_deg=360,period_s=5", 10))), 0.87, 0.1);
    const auto less = openMotor(FullChain + "&Kf=0.01845");
    setLaw(*less, recommended());
    EXPECT_NEAR(max_deg(moved(*less, move("sine,amplitude_deg=360,period_s=5", 10))), 0.15, 0.08);
    // Steps of 100 deg end within 0.1 deg, micro-steps settle within 0.09 deg in both cases; limits of 8.4.
    for (devices::Device* device : {more.get(), less.get()}) {
        EXPECT_LT(std::fabs(final_deg(moved(*device, move("step,amplitude_deg=100", 3)))), 0.32);
        EXPECT_LT(max_deg(moved(*device, move("staircase,amplitude_deg=0.32,period_s=1,count=10", 10))),
                  0.25);
    }
}

TEST(RecommendedSensitivity, staticFrictionFifteenPercentAboveKinetic) {
    const auto device = openMotor(FullChain + "&Ks_over_Kf=1.15");
    setLaw(*device, recommended());
    EXPECT_NEAR(max_deg(moved(*device, move("sine,amplitude_deg=360,period_s=5", 10))), 0.48, 0.1);
    EXPECT_LT(std::fabs(final_deg(moved(*device, move("step,amplitude_deg=100", 3)))), 0.32);
    EXPECT_LT(max_deg(moved(*device, move("staircase,amplitude_deg=0.32,period_s=1,count=10", 10))), 0.25);
}

struct SensitivityRow {
    double sine_deg;
    double step_deg;
    double micro_deg;
};

/// The three runs of section 8.4's sensitivity table, from a starting angle, with one board setting changed.
SensitivityRow sensitivity(double start_rad, const char* setting, double value) {
    const auto device = openMotor(FullChain + "&psi0=" + std::to_string(start_rad));
    setLaw(*device, recommended());
    setParameter(*device, setting, value);
    return {max_deg(moved(*device, move("sine,amplitude_deg=360,period_s=5", 10))),
            std::fabs(final_deg(moved(*device, move("step,amplitude_deg=100", 3)))),
            max_deg(moved(*device, move("staircase,amplitude_deg=0.32,period_s=1,count=10", 10)))};
}

constexpr double SensitivityStarts_rad[] = {0.0, 1.0, 2.5, -0.7, 0.3};

TEST(RecommendedSensitivity, linearDecodeCostsDegrees) {
    // Section 8.4: 3.0 deg on the sine, 0.9 deg after the step, 0.31 deg on micro-steps; the start is not
    // stated. All count from the start, whose own decoding error (up to 1.898 deg, 3.5) stays in them, so
    // they depend on it: the sine is never better than the line's own peak and never worse than twice that
    // beside the 0.64 deg of the loop, widened by the slope's ripple (0.785 to 1.111) on top of it; the other
    // two must lie on both sides of the quoted ones.
    SensitivityRow least{1e9, 1e9, 1e9};
    SensitivityRow most{0.0, 0.0, 0.0};
    for (const double start_rad : SensitivityStarts_rad) {
        const SensitivityRow row = sensitivity(start_rad, "decode.method", 1.0);
        least = {std::min(least.sine_deg, row.sine_deg), std::min(least.step_deg, row.step_deg),
                 std::min(least.micro_deg, row.micro_deg)};
        most = {std::max(most.sine_deg, row.sine_deg), std::max(most.step_deg, row.step_deg),
                std::max(most.micro_deg, row.micro_deg)};
    }
    EXPECT_NEAR(least.sine_deg, 3.0, 0.5); // the best start; +-0.5: where on the quantised sine it falls
    EXPECT_LT(most.sine_deg, 2.0 * 1.898 * 1.111 + 0.64);
    EXPECT_LT(least.step_deg, 0.9);
    EXPECT_GT(most.step_deg, 0.9);
    EXPECT_LT(most.step_deg, 2.0 * 1.898 + 0.32);
    EXPECT_LT(least.micro_deg, 0.31);
    EXPECT_GT(most.micro_deg, 0.31); // 0.25 is what the arctangent keeps from every start
}

TEST(RecommendedSensitivity, unstableWithoutStrayCompensation) {
    // Section 8.4: K_P + K_D/T_s = 180 A/rad exceeds B0/k_s = 62.8: 34 deg, 6.5 deg and no micro-steps. The
    // loop chatters, so single runs compare statistically only (section 11): the sines +-3 deg; the steps
    // stop anywhere (sigma 3 deg), their mean of five +-3.3 deg (2.5 sigma), none within the published 0.64
    // deg. Ten steps of 0.32 deg that are not made leave 3.2 deg; the chatter moves the rotor by a few
    // tenths.
    double step_deg = 0.0;
    for (const double start_rad : SensitivityStarts_rad) {
        const SensitivityRow row = sensitivity(start_rad, "stray.enabled", 0.0);
        EXPECT_NEAR(row.sine_deg, 34.0, 3.0) << start_rad;
        EXPECT_GT(row.step_deg, 0.64) << start_rad;
        EXPECT_NEAR(row.micro_deg, 3.2, 0.4) << start_rad;
        step_deg += row.step_deg / std::size(SensitivityStarts_rad);
    }
    EXPECT_NEAR(step_deg, 6.5, 3.3);
}

TEST(StartingAngle, doesNotMatterInTheIdealChain) {
    // Property 5 of section 10; the board's single precision leaves about 1e-5 of a step.
    std::vector<double> final;
    for (const char* query : {"chain=ideal", "chain=ideal&psi0=1.1", "chain=ideal&psi0=-2.9"}) {
        const auto device = openMotor(query);
        final.push_back(final_deg(moved(*device, move("step,amplitude_deg=180", 3))));
    }
    EXPECT_NEAR(final[0], final[1], 0.01);
    EXPECT_NEAR(final[0], final[2], 0.01);
}

TEST(StartingAngle, mattersByTheQuantisationOnlyInTheFullChain) {
    // Property 5: overshoot within the tolerance of section 8.1, final positions within +-0.25 deg (they
    // depend on the last bit of the friction's stop).
    for (const char* start : {"0.4", "1.9", "-2.2"}) {
        const auto device = openMotor(FullChain + "&psi0=" + start);
        const MoveResult result = moved(*device, move("step,amplitude_deg=180", 6));
        EXPECT_NEAR(result.truth->overshoot_percent.value_or(0), 27.9, 0.3 + 0.1) << start;
        EXPECT_NEAR(final_deg(result), -2.09, 0.25 + 0.2) << start;
    }
}

TEST(SampleDelay, oneSampleMakesThePublishedLoopGrow) {
    const auto steady = openMotor("chain=ideal&Kf=0");
    const auto delayed = openMotor("chain=ideal&Kf=0&delay_samples=1"); // section 5: pole radius 1.0080
    const MoveConfig config = move("step,amplitude_deg=5", 4);
    EXPECT_GT(max_deg(moved(*delayed, config)), 3.0 * max_deg(moved(*steady, config)));
}

} // namespace
} // namespace halbench::app
