#include "tests/app/procedures/simulated_motor.h"

#include <gtest/gtest.h>

#include <cmath>

// Figures of resources/help/htm-theory.md section 8 through the whole chain: plant, board, link, procedure.
// Tolerances of that section; "full chain" keeps quantisation, amplifier, noise and the compensated stray
// field.

namespace halbench::app {
namespace {

models::PositionLaw recommended() {
    return models::recommendedLaw(models::RotorConfig{}, 1.43e-2);
}

double max_deg(const MoveResult& result) {
    return radiansToDegrees(result.figures().maxError_rad);
}

double final_deg(const MoveResult& result) {
    return radiansToDegrees(result.figures().finalError_rad);
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
    EXPECT_NEAR(radiansToDegrees(result.truth->peakError_rad), 54.5, 0.3);
    EXPECT_NEAR(radiansToDegrees(result.truth->meanError_rad), 12.0, 0.3);
}

TEST(PublishedPreset, sinesErrAsDerived) {
    const auto device = openMotor(FullChain);
    const MoveResult small = moved(*device, move("sine,amplitude_deg=360,period_s=5", 10));
    EXPECT_NEAR(radiansToDegrees(small.truth->firstSecondError_rad), 46.6, 0.5);
    EXPECT_NEAR(max_deg(small), 19.0, 0.5);
    EXPECT_NEAR(radiansToDegrees(small.truth->rmsError_rad), 11.1, 0.3);
    const MoveResult large = moved(*device, move("sine,amplitude_deg=500,period_s=5", 10));
    EXPECT_NEAR(radiansToDegrees(large.truth->firstSecondError_rad), 76.2, 0.5);
    EXPECT_NEAR(max_deg(large), 21.5, 0.5);
    EXPECT_NEAR(radiansToDegrees(large.truth->rmsError_rad), 12.4, 0.3);
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

TEST(DegreePreset, largeStepsEndInALimitCycle) {
    const auto device = openMotor(FullChain);
    setLaw(*device, models::publishedInDegreesLaw());
    const MoveResult result = moved(*device, move("step,amplitude_deg=100", 6));
    const std::vector<double> position = result.recording.column("truth.position");
    const auto [low, high] = std::minmax_element(position.begin() + 4000, position.end());
    const double peakToPeak_deg = radiansToDegrees(*high - *low);
    EXPECT_GT(peakToPeak_deg, 1.8); // 2.2 to 3.2 in the reference, comparable statistically only (section 11)
    EXPECT_LT(peakToPeak_deg, 4.0);
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
        EXPECT_NEAR(radiansToDegrees(result.truth->rmsError_rad), 0.16, 0.04) << sine;
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

TEST(RecommendedSensitivity, linearDecodeCostsDegrees) {
    const auto device = openMotor(FullChain);
    setLaw(*device, recommended());
    setParameter(*device, "decode.method", 1.0);
    EXPECT_NEAR(max_deg(moved(*device, move("sine,amplitude_deg=360,period_s=5", 10))), 3.0, 0.5);
}

TEST(RecommendedSensitivity, unstableWithoutStrayCompensation) {
    // Section 8.4: K_P + K_D/T_s = 180 A/rad exceeds B0/k_s = 62.8: 34 deg on the sine instead of 0.42.
    const auto device = openMotor(FullChain);
    setLaw(*device, recommended());
    setParameter(*device, "stray.enabled", 0.0);
    EXPECT_GT(max_deg(moved(*device, move("sine,amplitude_deg=360,period_s=5", 10))), 5.0);
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
