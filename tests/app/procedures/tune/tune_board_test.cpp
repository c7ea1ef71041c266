// What a method promises of its step is what the simulated board does with the gains it was given: design,
// prediction and board are one law.
#include "app/procedures/tune/tune.h"
#include "tests/app/procedures/simulated_motor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

/// The published motor without friction: what the linear prediction is of.
MotorEstimate frictionless() {
    MotorEstimate estimate;
    estimate.values = {{"J", 5.5e-4}, {"c", 1.23e-3}, {"Kf", 0.0}, {"phi", 1.43e-2}};
    return estimate;
}

/// Largest distance, relative to the step, between the board's step and the linear prediction.
double distanceFromPrediction(const TuneResult& tuned, double step_rad) {
    const auto device =
        openMotor("chain=ideal&Kf=0&delay_samples=" + std::to_string(tuned.conditions.timing.delay_samples));
    const auto values = lawForDevice(tuned.law, device->catalogue());
    EXPECT_TRUE(values.has_value()) << values.error().message;
    EXPECT_TRUE(device->writeParameters(*values).has_value());
    const MoveResult result = moved(*device, move("step,amplitude_rad=" + std::to_string(step_rad), 0.9));
    const std::vector<double> truth_rad = result.recording.column("truth.position");
    const std::vector<double>& predicted = tuned.predicted.stepCurve.response_rad;
    EXPECT_LE(result.peakCurrent_A.value(), 4.0 * 0.999) << "the limit would not be linear";
    double largest = 0.0;
    for (std::size_t i = 0; i < std::min(truth_rad.size(), predicted.size()); ++i) {
        largest = std::max(largest, std::abs((truth_rad[i] - truth_rad.front()) / step_rad - predicted[i]));
    }
    return largest;
}

// The board reckons in single precision, and its angle is the sum of many increments: 1e-5 of a radian of
// 0.01 rad is 1e-3. A derivative filter of one sample, left out of the prediction, would be 40 times that.
TEST(TunedBoard, answersASmallStepAsTheMethodPredicts) {
    std::size_t moved = 0;
    for (const control::DesignMethod& method : control::designMethods()) {
        for (const int delay : {0, 1}) {
            TuneConfig config;
            config.method = std::string(method.name);
            config.conditions.timing.delay_samples = delay;
            config.targets.bandwidth_Hz = method.name == "bandwidth" ? std::optional(5.0) : std::nullopt;
            config.targets.phaseMargin_deg =
                method.name == "phase-margin" ? std::optional(45.0) : std::nullopt;
            const auto tuned = runTune(frictionless(), config);
            if (!tuned) { // ziegler-nichols-pi: unstable on this motor
                EXPECT_EQ(tuned.error().code, ErrorCode::Refused) << method.name;
            } else if (tuned->predicted.isStable) {
                EXPECT_LT(distanceFromPrediction(*tuned, 0.01), 1e-3) << method.name << " " << delay;
                ++moved;
            }
        }
    }
    EXPECT_GE(moved, 24U);
}

TEST(TunedBoard, takesNoGainsWithAFilterThatItHasNot) {
    control::PositionLaw law = runTune(frictionless(), {})->law;
    law.gains.filter_s = 0.01;
    const auto device = openMotor("chain=ideal");
    for (const Error& error :
         {lawForDevice(law, device->catalogue()).error(), judgeLaw(frictionless(), law, {}).error(),
          runAnalysis(frictionless(), law, {}).error()}) {
        EXPECT_EQ(error.code, ErrorCode::InvalidInput);
        EXPECT_NE(error.message.find("0.01 s"), std::string::npos) << error.message;
        EXPECT_FALSE(error.hint.empty());
    }
    law.gains.filter_s = 0.0; // the difference over one sample: what the board has
    EXPECT_TRUE(judgeLaw(frictionless(), law, {}).has_value());
}

} // namespace
} // namespace halbench::app
