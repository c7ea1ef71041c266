#include "app/documents/text/output_file.h"
#include "app/procedures/tune/tune.h"
#include "app/tuning/loop_conditions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

namespace halbench::app {
namespace {

namespace fs = std::filesystem;

TuneConfig recommendedOn(const LoopConditions& conditions) {
    TuneConfig config;
    config.conditions = conditions;
    return config;
}

bool warnsOfStrayError(const LoopConditions& conditions) {
    MotorEstimate motor;
    motor.values = {{"J", 5.5e-4}, {"c", 1.23e-3}, {"Kf", 2.05e-2}, {"phi", 1.43e-2}};
    const Result<TuneResult> result = runTune(motor, recommendedOn(conditions));
    EXPECT_TRUE(result.has_value());
    return std::any_of(result->warnings.begin(), result->warnings.end(),
                       [](const Finding& finding) { return finding.code == "stray_field_error"; });
}

LoopConditions conditions() {
    return loopConditionsOf("htm").value();
}

CalibrateResult calibrated(double low_T_per_A, double high_T_per_A) {
    CalibrateResult result;
    result.figures = {{"hall.offset", "T", {}},
                      {"stray.coefficient",
                       "T/A",
                       {0.5 * (low_T_per_A + high_T_per_A), std::pair(low_T_per_A, high_T_per_A),
                        control::EstimateSource::Identified, "T/A"}}};
    return result;
}

// 180 A/rad need k_s = 2.5 mT/A to 35 %; the warning begins at 20 % = 0.5 mT/A (htm-theory.md 8.4).
TEST(StrayInterval, warnsOnBothSidesOfTheRule) {
    for (const auto& [half_T_per_A, isWarned] : {std::pair(0.47e-3, false), std::pair(0.53e-3, true)}) {
        LoopConditions known = conditions();
        takeStrayInterval(known, strayInterval(calibrated(2.5e-3 - half_T_per_A, 2.5e-3 + half_T_per_A)));
        ASSERT_TRUE(known.stray && known.stray->error_T_per_A);
        EXPECT_NEAR(*known.stray->error_T_per_A, half_T_per_A, 1e-12);
        EXPECT_EQ(warnsOfStrayError(known), isWarned) << half_T_per_A;
    }
}

TEST(StrayInterval, ofACalibrationThatTheBoardDoesNotUseCountsByItsDistance) {
    LoopConditions known = conditions(); // the board still has 2.5 mT/A
    takeStrayInterval(known, strayInterval(calibrated(3.0e-3, 3.1e-3)));
    EXPECT_NEAR(*known.stray->error_T_per_A, 0.6e-3, 1e-12);
    EXPECT_TRUE(warnsOfStrayError(known));
}

TEST(StrayInterval, leavesUnknownWhatWasNotCalibrated) {
    LoopConditions unknown = conditions();
    takeStrayInterval(unknown, strayInterval(CalibrateResult{}));
    EXPECT_FALSE(unknown.stray->error_T_per_A.has_value());
    LoopConditions without;
    takeStrayInterval(without, std::pair(1e-3, 2e-3));
    EXPECT_FALSE(without.stray.has_value());
}

class CalibrationOption : public ::testing::Test {
protected:
    void SetUp() override { fs::create_directories(m_folder); }
    void TearDown() override { fs::remove_all(m_folder); }
    std::string file(const std::string& text) {
        const std::string path = (m_folder / "cal.json").string();
        EXPECT_TRUE(writeFile(path, text).has_value());
        return path;
    }
    /// Of its own for each test: they run side by side.
    const fs::path m_folder = fs::path(::testing::TempDir()) /
                              ("halbench_calibration_" +
                               std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST_F(CalibrationOption, readsTheFileAndKnowsWhetherItRunsOnTheBoard) {
    for (const auto& [applied, error_T_per_A] : {std::pair("true", 0.05e-3), std::pair("false", 0.55e-3)}) {
        LoopConditions known = conditions();
        const std::string path =
            file(std::string(R"({"schema": "halbench.calibration/1", "applied": )") + applied +
                 R"(, "figures": {"stray.coefficient": {"value": 3.0e-3, "ci95": [2.95e-3, 3.05e-3]}}})");
        const Result<void> taken = takeCalibration(known, path);
        ASSERT_TRUE(taken.has_value()) << taken.error().message;
        EXPECT_NEAR(*known.stray->error_T_per_A, error_T_per_A, 1e-12) << applied;
    }
}

TEST_F(CalibrationOption, refusesAFileWithoutTheCoefficient) {
    LoopConditions known = conditions();
    const std::string none = file(R"({"schema": "halbench.calibration/1", "applied": true, "figures": {}})");
    EXPECT_EQ(takeCalibration(known, none).error().code, ErrorCode::Refused);
    EXPECT_EQ(takeCalibration(known, m_folder.string() + "/no.json").error().code, ErrorCode::FileSystem);
    for (const char* wrong : {R"({"schema": "halbench.gains/1", "applied": true, "figures": {}})",
                              R"({"schema": "halbench.calibration/1", "applied": true,
              "figures": {"stray.coefficient": {"value": 3e-3, "ci95": [1e-3]}}})"}) {
        const Result<void> taken = takeCalibration(known, file(wrong));
        ASSERT_FALSE(taken.has_value());
        EXPECT_EQ(taken.error().code, ErrorCode::InvalidInput);
        EXPECT_NE(taken.error().message.find("cal.json"), std::string::npos);
    }
    EXPECT_TRUE(takeCalibration(known, "").has_value());
    EXPECT_FALSE(known.stray->error_T_per_A.has_value());
}

} // namespace
} // namespace halbench::app
