#include "app/analyses/spherical/orientation_readings.h"
#include "tests/app/analyses/recorded_poses.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace halbench::app {
namespace {

// Readings as a converter of that range gives them: the positive end is a step below.
devices::RecordedFile clippedPoses(int rows, double range_T) {
    devices::RecordedFile file = recordedPoses(rows, Noise_T);
    const double step_T = range_T / 2048.0;
    for (int row = 0; row < rows; ++row) {
        for (std::size_t i = 0; i < 9; ++i) {
            double& reading_T = file.recording.values[12 * static_cast<std::size_t>(row) + i];
            reading_T =
                std::fmin(range_T - step_T, std::fmax(-range_T, step_T * std::round(reading_T / step_T)));
        }
    }
    return file;
}

// The ends of the range are found from the readings: the same poses are left out as with the range given.
TEST(OrientationAnalysisTest, saturationIsFoundWithoutTheRange) {
    for (const double range_T : {1e-3, 20e-3, 100e-3}) {
        const devices::RecordedFile file = clippedPoses(500, range_T);
        const auto found = run("orient", {}, {{"truth", true}}, &file);
        const auto given =
            run("orient", {{"range_mT", std::to_string(1e3 * range_T)}}, {{"truth", true}}, &file);
        ASSERT_TRUE(found) << found.error().message;
        ASSERT_TRUE(given);
        for (const char* verdict :
             {"determined", "reduced", "ambiguous", "not_determined", "not_converged"}) {
            EXPECT_EQ(number(found->body, {verdict}), number(given->body, {verdict})) << range_T << verdict;
        }
        EXPECT_NE(found->quality.verdict, Verdict::Good);
        const auto& findings = found->quality.findings;
        EXPECT_TRUE(std::any_of(findings.begin(), findings.end(),
                                [](const Finding& finding) { return finding.code == "saturated"; }));
    }
}

// Eight channels or more at the ends in every row: no pose is left.
TEST(OrientationAnalysisTest, withAllChannelsSaturatedNoPoseIsGiven) {
    const devices::RecordedFile file = clippedPoses(100, 0.1e-3);
    const auto moving = run("orient", {}, {{"truth", true}}, &file);
    ASSERT_TRUE(moving) << moving.error().message;
    EXPECT_EQ(moving->quality.verdict, Verdict::Refused);
    EXPECT_EQ(number(moving->body, {"determined"}) + number(moving->body, {"reduced"}), 0.0);
    devices::RecordedFile resting = file;
    for (std::size_t i = 0; i < resting.recording.values.size(); ++i) {
        resting.recording.values[i] = i % 12 < 9 ? (i % 2 == 0 ? 0.13 : -0.13) : 0.0;
    }
    const auto still = run("orient", {}, {}, &resting);
    ASSERT_TRUE(still);
    EXPECT_EQ(still->quality.verdict, Verdict::Refused);
}

TEST(OrientationAnalysisTest, healthyExtremesAreNotSaturated) {
    // At rest at gamma = 22.5 degrees sensors 0 and 1 read the same R, the largest of all.
    devices::RecordedFile resting = recordedPoses(50, 0.0);
    const models::RotorField field{models::RotorFieldConfig{}};
    const models::SensorPoses poses =
        models::sensorPoses(models::publishedPlacement(), models::SensorFrames::Zyx, 0.05);
    const models::SphericalReadings readings =
        field.readings_T(models::rotationOf({0.0, 0.0, Pi / 8.0}), poses);
    // A spin at zero tilt, rounded to 12 bit: both turn at the same largest value.
    devices::RecordedFile spinning = recordedPoses(720, 0.0);
    constexpr double Step_T = 0.3 / 2048.0;
    for (std::size_t row = 0; row < 720; ++row) {
        const models::SphericalReadings spun = field.readings_T(
            models::rotationOf({0.0, 0.0, degreesToRadians(0.5 * static_cast<double>(row))}), poses);
        for (std::size_t i = 0; i < 9; ++i) {
            const auto channel = static_cast<Eigen::Index>(i);
            spinning.recording.values[12 * row + i] = Step_T * std::round(spun[channel] / Step_T);
            if (row < 50) {
                resting.recording.values[12 * row + i] = readings[channel];
            }
        }
    }
    for (const devices::RecordedFile* file : {&resting, &spinning}) {
        const auto values = parseAnalysisValues(*findAnalysis("orient"), {}, {});
        const auto read = orientationReadings(*values, *file, "motion.csv");
        ASSERT_TRUE(read);
        EXPECT_FALSE(read->saturation_T);
    }
}

TEST(OrientationAnalysisTest, withoutRowsItSaysWhatItLookedFor) {
    const devices::RecordedFile file = recordedPoses(0, 0.0);
    const auto result = run("orient", {}, {}, &file);
    ASSERT_FALSE(result);
    EXPECT_THAT(result.error().message, testing::HasSubstr("no rows of field.0.r, field.0.theta"));
    EXPECT_THAT(result.error().hint, testing::HasSubstr("field.0.r [T]"));
    const auto none = run("orient", {{"range_mT", "1"}}, {}, &file);
    ASSERT_FALSE(none);
}

devices::RecordedFile stressedSpecimens() {
    models::RotorFieldConfig config;
    config.harmonics = models::harmonicPreset(models::HarmonicPreset::H2);
    return recordedSpecimens(config);
}

// Harmonics as strong as the field itself: their prediction and subtraction does not settle everywhere, and
// the fit with other starts decides. Of sensors as assembled the readings of the true pose may be worse than
// those of one beside it: at most 2 in 1000.
TEST(OrientationRefusal, strongHarmonicsGiveNoWrongBranch) {
    const devices::RecordedFile file = stressedSpecimens();
    const auto result = run("orient", {{"harmonics", "h2"}}, {{"truth", true}}, &file);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_GT(number(result->body, {"determined"}), 2850.0);
    EXPECT_LE(number(result->body, {"truth", "wrong_branches"}), 6.0);
    EXPECT_NE(result->quality.verdict, Verdict::Good);
}

// The same readings taken for those of a field without harmonics: no pose explains them.
TEST(OrientationRefusal, aFieldThatIsNotTheModelsIsRefused) {
    const devices::RecordedFile file = stressedSpecimens();
    const auto result = run("orient", {}, {{"truth", true}}, &file);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->quality.verdict, Verdict::Refused);
    EXPECT_GT(number(result->body, {"not_converged"}), 2700.0);
    EXPECT_THAT(result->quality.findings.front().hint, testing::HasSubstr("harmonics"));
}

// One row of another field in a healthy recording is not usable, the others are.
TEST(OrientationRefusal, aSingleRowThatNoPoseExplainsIsNotUsable) {
    devices::RecordedFile file = recordedPoses(100, Noise_T);
    file.recording.values[12 * 50 + 4] += 0.5; // Theta of sensor 1
    const auto result = run("orient", {}, {}, &file);
    ASSERT_TRUE(result);
    EXPECT_EQ(number(result->body, {"not_converged"}), 1.0);
    EXPECT_EQ(number(result->body, {"determined"}), 99.0);
    EXPECT_EQ(result->quality.verdict, Verdict::Doubtful);
    for (std::size_t row = 0; row < 60; ++row) {
        file.recording.values[12 * row + 4] += 0.5;
    }
    const auto most = run("orient", {}, {}, &file);
    ASSERT_TRUE(most);
    EXPECT_EQ(most->quality.verdict, Verdict::Refused);
    EXPECT_EQ(most->quality.findings.back().code, "model_does_not_fit");
}

} // namespace
} // namespace halbench::app
