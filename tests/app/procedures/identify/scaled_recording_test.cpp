#include "tests/app/procedures/recorded_motor.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace halbench::app {
namespace {

// A short excitation of the published motor: two currents each way with their coast-downs.
Recording shortRecording() {
    MotorRecorder recorder({}, 3);
    recorder.run(0.0, 0.5);
    for (const double current_A : {2.5, 0.0, 4.0, 0.0, -2.5, 0.0, -4.0, 0.0}) {
        recorder.run(current_A, current_A == 0.0 ? 1.0 : 2.5);
    }
    return recorder.recording;
}

// Verdict or message: anything but an assertion, which ends the test.
std::string outcomeOf(const Recording& recording) {
    IdentifyConfig config;
    config.given.inertia_kg_m2 = 5.5e-4;
    const auto result = identifyRecording(recording, config);
    return result ? std::string(verdictName(result->quality.verdict)) : result.error().message;
}

TEST(IdentifyScaledRecording, timeOfAnyScaleIsJudgedOrRefused) {
    for (const double scale : {1.0 / 30.0, 0.05, 0.1, 0.2, 1.0 / 3.0, 0.6, 1.0, 2.0, 5.0, 10.0, 30.0}) {
        Recording recording = shortRecording();
        for (double& time_s : recording.time_s) {
            time_s *= scale;
        }
        EXPECT_FALSE(outcomeOf(recording).empty()) << scale;
    }
}

TEST(IdentifyScaledRecording, angleAndCurrentOfAnyScaleAreJudgedOrRefused) {
    for (const std::size_t column : {0, 1}) {
        for (const double scale : {-1.0, 0.0, 1e-6, 1e-3, 0.1, 10.0, 1e3, 1e6}) {
            Recording recording = shortRecording();
            for (std::size_t at = column; at < recording.values.size(); at += 2) {
                recording.values[at] *= scale;
            }
            EXPECT_FALSE(outcomeOf(recording).empty()) << column << " " << scale;
        }
    }
}

TEST(IdentifyScaledRecording, fasterTimeThanTheMotorsLeavesItsQuotients) {
    // With t/3 the same angles belong to a motor of three times c/J and nine times phi/J: physics does not
    // exclude it, and a recording without a board's facts holds nothing against it.
    Recording recording = shortRecording();
    for (double& time_s : recording.time_s) {
        time_s /= 3.0;
    }
    const auto result = identifyRecording(recording, {});
    ASSERT_TRUE(result) << result.error().message;
    const auto damping = result->ratios.find("c_over_J");
    ASSERT_TRUE(damping != result->ratios.end() && damping->second.value);
    EXPECT_NEAR(*damping->second.value, 3.0 * 1.23e-3 / 5.5e-4, 0.07); // 1 %: one turn of few stretches
}

} // namespace
} // namespace halbench::app
