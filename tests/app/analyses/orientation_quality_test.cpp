#include "app/analyses/spherical/orientation_quality.h"
#include "models/spherical/additive_model.h"
#include "tests/app/analyses/recorded_poses.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace halbench::app {
namespace {

/// Readings of the additive device whose sensors are `radius_m` from the centre, without noise: the field
/// falls with the fourth power of the distance.
devices::RecordedFile additivePoses(int rows, double radius_m) {
    devices::RecordedFile file = recordedPoses(rows, 0.0);
    models::AdditiveModel model;
    model.strength_T *= std::pow(0.05 / radius_m, 4);
    for (std::size_t row = 0; row < static_cast<std::size_t>(rows); ++row) {
        double* values = &file.recording.values[12 * row];
        const models::SphericalReadings readings_T =
            models::additiveReadings_T(model, {values[9], values[10], values[11]});
        std::copy(readings_T.begin(), readings_T.end(), values);
    }
    return file;
}

/// All nine readings, as with sensors or a rotor that are turned round.
devices::RecordedFile reversed(devices::RecordedFile file) {
    for (std::size_t i = 0; i < file.recording.values.size(); ++i) {
        file.recording.values[i] *= i % 12 < 9 ? -1.0 : 1.0;
    }
    return file;
}

const Finding* finding(const AnalysisOutcome& outcome, const char* code) {
    const auto& all = outcome.quality.findings;
    const auto found =
        std::find_if(all.begin(), all.end(), [code](const Finding& f) { return f.code == code; });
    return found == all.end() ? nullptr : &*found;
}

} // namespace

// The closed form solves the additive model exactly: rounding alone is left, whatever the distance.
TEST(OrientationQualityTest, additiveEstimatorsHoldAtAnyDistance) {
    for (const char* radius_mm : {"47", "50", "60", "85.5"}) {
        const devices::RecordedFile file = additivePoses(200, std::stod(radius_mm) / 1e3);
        for (const char* estimator : {"closed", "closed-fitted"}) {
            const auto result =
                run("orient", {{"estimator", estimator}, {"radius_mm", radius_mm}}, {{"truth", true}}, &file);
            ASSERT_TRUE(result) << result.error().message;
            EXPECT_LT(number(result->body, {"truth", "worst_deg"}), 1e-4) << radius_mm << estimator;
            EXPECT_EQ(result->quality.verdict, Verdict::Good) << radius_mm << estimator;
        }
    }
}

// The same estimators compared: 60 mm is as good as 50 mm, where nothing is noisy.
TEST(OrientationQualityTest, comparedEstimatorsHoldAtAnyDistance) {
    for (const char* radius_mm : {"50", "60"}) {
        const auto result = run(
            "estimators",
            {{"device", "paper"}, {"radius_mm", radius_mm}, {"only", "closed-fitted"}, {"count", "100"}}, {});
        ASSERT_TRUE(result) << result.error().message;
        const JsonValue* rows = result->body.find("estimators");
        ASSERT_NE(rows, nullptr);
        EXPECT_EQ(number(rows->items().front(), {"failures"}), 0.0) << radius_mm;
    }
}

TEST(OrientationQualityTest, anAdditiveEstimatorThatDoesNotFitIsNotGood) {
    const devices::RecordedFile exact = recordedPoses(200, 0.0);
    const auto crossed = run("orient", {{"estimator", "closed"}}, {}, &exact);
    ASSERT_TRUE(crossed);
    EXPECT_EQ(crossed->quality.verdict, Verdict::Doubtful);
    EXPECT_NE(finding(*crossed, "additive_model_does_not_fit"), nullptr);
    const devices::RecordedFile farther = additivePoses(200, 0.06); // believed at 50 mm
    const auto elsewhere = run("orient", {{"estimator", "closed-fitted"}}, {}, &farther);
    ASSERT_TRUE(elsewhere);
    EXPECT_NE(elsewhere->quality.verdict, Verdict::Good);
}

const AnalysisTable& tableOf(const Result<AnalysisOutcome>& result) {
    return *result->table;
}

double cell(const AnalysisTable& table, std::size_t row, const char* name) {
    const auto column = std::find(table.columns.begin(), table.columns.end(), name) - table.columns.begin();
    return table.values[row * table.columns.size() + static_cast<std::size_t>(column)];
}

// 3000 poses scatter by 0.4 %; 3.5 of that. Tolerances of the sensors only widen the intervals.
TEST(OrientationQualityTest, additiveEstimatorsHaveIntervalsThatHoldTheTruth) {
    devices::RecordedFile file = additivePoses(3000, 0.05);
    Random random(Seed);
    for (std::size_t i = 0; i < file.recording.values.size(); ++i) {
        file.recording.values[i] += i % 12 < 9 ? Noise_T * random.gaussian() : 0.0;
    }
    for (const char* estimator : {"closed", "closed-fitted"}) {
        const auto result =
            run("orient", {{"estimator", estimator}, {"tolerance", "none"}}, {{"truth", true}}, &file);
        ASSERT_TRUE(result) << result.error().message;
        EXPECT_EQ(result->quality.verdict, Verdict::Good) << estimator;
        for (const char* angle : {"alpha", "beta", "gamma"}) {
            const std::size_t which = std::string_view(angle) == "alpha" ? 9 : *angle == 'b' ? 10 : 11;
            int held = 0;
            for (std::size_t row = 0; row < 3000; ++row) {
                const double off_rad = cell(tableOf(result), row, (std::string(angle) + "_rad").c_str()) -
                                       file.recording.values[12 * row + which];
                held += std::abs(off_rad) <=
                        cell(tableOf(result), row, (std::string(angle) + "_half95_rad").c_str());
            }
            EXPECT_NEAR(held / 3000.0, 0.95, 0.014) << estimator << " " << angle;
        }
        EXPECT_NEAR(number(result->body, {"chi_square", "freedom"}), 6.0, 0.0);
        EXPECT_NEAR(number(result->body, {"chi_square", "mean"}), 6.0, 0.22); // 3.5 sqrt(12/3000)
        const auto assembled = run("orient", {{"estimator", estimator}}, {}, &file);
        EXPECT_GT(number(assembled->body, {"cone95_deg", "median"}),
                  10.0 * number(result->body, {"cone95_deg", "median"})); // 3.65 mT beside 0.1 mT
    }
}

/// The recording with a column of flags behind the others.
devices::RecordedFile withFlags(const devices::RecordedFile& file, double flags) {
    devices::RecordedFile result = file;
    auto layout = std::make_shared<StreamLayout>(*file.recording.layout);
    layout->columns.push_back({"channels_left_out", ""});
    result.recording.layout = layout;
    result.recording.values.clear();
    for (std::size_t row = 0; row < file.recording.rows(); ++row) {
        const auto first = file.recording.values.begin() + static_cast<std::ptrdiff_t>(12 * row);
        result.recording.values.insert(result.recording.values.end(), first, first + 12);
        result.recording.values.push_back(flags);
    }
    return result;
}

// Sensors 0 and 1 in each other's place: bit 0 is the board's field.0.r wherever that stands.
TEST(OrientationQualityTest, aChannelIsLeftOutByItsNameNotItsPlace) {
    devices::RecordedFile file = recordedPoses(50, Noise_T);
    for (std::size_t row = 0; row < 50; ++row) {
        file.recording.values[12 * row] = 0.0; // dead
    }
    const devices::RecordedFile flagged = withFlags(file, 1.0);
    const std::map<std::string, std::string> swapped = {
        {"readings",
         "field.1.r,field.1.theta,field.1.phi,field.0.r,field.0.theta,field.0.phi,field.2.r,field.2."
         "theta,field.2.phi"},
        {"placement", "0,0,45,0,0,0,45,45,-90"}};
    const auto usual = run("orient", {}, {{"truth", true}}, &flagged);
    const auto other = run("orient", swapped, {{"truth", true}}, &flagged);
    ASSERT_TRUE(usual) << usual.error().message;
    ASSERT_TRUE(other) << other.error().message;
    EXPECT_EQ(number(usual->body, {"determined"}), 50.0);
    EXPECT_EQ(number(other->body, {"determined"}), 50.0);
    EXPECT_NEAR(number(other->body, {"truth", "rms_deg"}), number(usual->body, {"truth", "rms_deg"}), 1e-6);
}

TEST(OrientationQualityTest, flagsThatNoBoardWritesAreRefusedWithTheirRow) {
    const devices::RecordedFile file = recordedPoses(5, Noise_T);
    for (const double flags : {-1.0, 0.4, 512.0, 1e300, HUGE_VAL}) {
        const devices::RecordedFile flagged = withFlags(file, flags);
        const auto result = run("orient", {}, {}, &flagged);
        ASSERT_FALSE(result) << flags;
        EXPECT_EQ(result.error().code, ErrorCode::InvalidInput);
        EXPECT_NE(result.error().message.find("row 1: channels_left_out"), std::string::npos);
    }
    const devices::RecordedFile gap = withFlags(file, NAN); // a row that was lost
    EXPECT_TRUE(run("orient", {}, {}, &gap));
}

// Chi-square is of the poses that have it: six degrees of freedom whether or not others have a cone.
TEST(OrientationQualityTest, freedomIsThatOfThePosesWithAnUncertainty) {
    devices::RecordedFile mixed = additivePoses(20, 0.05);
    const devices::RecordedFile physical = recordedPoses(100, Noise_T);
    const std::size_t columns = mixed.recording.layout->columns.size();
    for (std::size_t row = 0; row < 100; ++row) {
        const auto first = physical.recording.values.begin() + static_cast<std::ptrdiff_t>(12 * row);
        mixed.recording.values.insert(mixed.recording.values.end(), first,
                                      first + static_cast<std::ptrdiff_t>(columns));
        mixed.recording.time_s.push_back(1.0 + 0.001 * static_cast<double>(row));
    }
    const auto result = run("orient", {{"estimator", "closed"}, {"tolerance", "none"}}, {}, &mixed);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_NE(finding(*result, "cone_not_available"), nullptr);
    EXPECT_EQ(number(result->body, {"chi_square", "freedom"}), 6.0);
}

TEST(OrientationQualityTest, aConeThatWouldBeAGuessIsMissingWithItsReason) {
    const devices::RecordedFile exact = recordedPoses(200, Noise_T);
    const auto crossed = run("orient", {{"estimator", "closed"}, {"tolerance", "none"}}, {}, &exact);
    ASSERT_TRUE(crossed);
    EXPECT_NE(finding(*crossed, "cone_not_available"), nullptr);
    const JsonValue& pose = crossed->body.find("poses")->items().front();
    EXPECT_TRUE(pose.find("cone95_deg")->isNull());
    EXPECT_TRUE(pose.find("alpha_half95_deg")->isNull());
    EXPECT_EQ(pose.find("cone95_missing")->text(), "model_does_not_fit");
    // Without a step of the projection the search ends where it happens to be.
    const devices::RecordedFile own = additivePoses(20, 0.05);
    const auto searched = run("orient", {{"estimator", "swarm"}, {"projection_steps", "0"}}, {}, &own);
    ASSERT_TRUE(searched) << searched.error().message;
    const JsonValue& loose = searched->body.find("poses")->items().front();
    EXPECT_EQ(loose.find("cone95_missing")->text(), "not_settled");
    EXPECT_EQ(number(searched->body, {"search", "projection_steps"}), 0.0);
    EXPECT_TRUE(crossed->body.find("search")->isNull());
}

// Readings of the other sign are those of a rotor turned by 90 degrees about its shaft: no residual tells.
TEST(OrientationQualityTest, readingsOfTheWrongSignAreRefusedWhereTheTruthIsKnown) {
    const devices::RecordedFile healthy = recordedPoses(300, Noise_T);
    for (const char* estimator : {"refined", "tensor", "lm"}) {
        const devices::RecordedFile file = reversed(healthy);
        const auto result = run("orient", {{"estimator", estimator}}, {{"truth", true}}, &file);
        ASSERT_TRUE(result) << result.error().message;
        EXPECT_EQ(number(result->body, {"truth", "wrong_branches"}), 300.0) << estimator;
        EXPECT_EQ(result->quality.verdict, Verdict::Refused) << estimator;
        const Finding* wrong = finding(*result, "disagrees_with_truth");
        ASSERT_NE(wrong, nullptr);
        EXPECT_THAT(wrong->hint, testing::HasSubstr("sign of the readings"));
        const auto right = run("orient", {{"estimator", estimator}}, {{"truth", true}}, &healthy);
        ASSERT_TRUE(right);
        EXPECT_EQ(right->quality.verdict, Verdict::Good) << estimator;
    }
}

// A uniform field as three more unknowns is told from the tensor by a singular value of 0.0535 only: errors
// of sensors as assembled, some mT, become as large as the tensor itself (spherical-theory.md section 5).
TEST(OrientationQualityTest, aStrayFieldFromSensorsThatWereNotCalibratedIsRefused) {
    const devices::RecordedFile file = recordedSpecimens();
    for (const char* estimator : {"refined", "lm"}) {
        const auto result =
            run("orient", {{"estimator", estimator}}, {{"truth", true}, {"stray", true}}, &file);
        ASSERT_TRUE(result) << result.error().message;
        EXPECT_EQ(result->quality.verdict, Verdict::Refused) << estimator;
        EXPECT_NE(finding(*result, "stray_field_not_separable"), nullptr) << estimator;
    }
    const devices::RecordedFile ideal = recordedPoses(300, 10e-6);
    const auto exact = run("orient", {{"tolerance", "none"}, {"noise_uT", "10"}},
                           {{"truth", true}, {"stray", true}}, &ideal);
    ASSERT_TRUE(exact);
    EXPECT_EQ(exact->quality.verdict, Verdict::Good);
}

} // namespace halbench::app
