#include "app/documents/identification_file.h"
#include "app/documents/result_documents.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

control::Estimate identified(double value, double half, const std::string& unit) {
    return {value, std::pair(value - half, value + half), control::EstimateSource::Identified, unit};
}

IdentifyResult result() {
    IdentifyResult made;
    made.viscousDamping = identified(1.23e-3, 4e-5, "N*m*s/rad");
    made.coulombFriction = identified(2.05e-2, 8e-4, "N*m");
    made.inertia = {5.5e-4, std::pair(5.5e-4, 5.5e-4), control::EstimateSource::Given, "kg*m^2"};
    made.ratios["c_over_J"] = identified(2.236, 0.004, "1/s");
    made.asymmetry = identified(0.05, 0.01, "");
    made.rSquared = 0.9967;
    made.residualRms_rad_s = 0.41;
    made.points = {{2.0, 5.1, true, 0.97, {}}, {-2.0, -5.0, false, 0.0, "the rotor stopped"}};
    made.covarianceNames = {"viscous_damping", "coulomb_friction"};
    made.covariance = {{4e-10, -7e-9}, {-7e-9, 1.6e-7}};
    made.quality = {Verdict::Doubtful, {{"outliers", "one point is far away", "look at it"}}};
    made.duration_s = 231.5;
    made.highestTemperature_degC = 41.25;
    made.notes = {{"runs_test_p", 0.42}};
    made.timing = {0.01, 1};
    return made;
}

std::string written(const ResultHeader& header, const IdentifyResult& made) {
    return toJsonText(identificationDocument(header, made)).value();
}

ResultHeader header() {
    ResultHeader made;
    made.schema = "halbench.identification/1";
    made.device =
        devices::DeviceInfo{"", "htm", "sim-htm-7", "FW", "", true, {{"c", "0.002"}, {"chain", "ideal"}}};
    made.started = "2026-05-04T03:02:01Z";
    made.seed = 7;
    return made;
}

TEST(IdentificationFile, whatWasReadWritesTheSameBytesAgain) {
    const std::string text = written(header(), result());
    const auto file = parseIdentification(text, "model.json");
    ASSERT_TRUE(file) << file.error().message;
    EXPECT_EQ(written(file->header, file->result), text);
}

TEST(IdentificationFile, aTemperatureThatWasNotRecordedStaysAbsent) {
    IdentifyResult made = result();
    made.highestTemperature_degC.reset();
    const std::string text = written(header(), made);
    EXPECT_NE(text.find("\"highest_temperature_degC\": null"), std::string::npos);
    const auto file = parseIdentification(text, "model.json");
    ASSERT_TRUE(file) << file.error().message;
    EXPECT_FALSE(file->result.highestTemperature_degC);
}

TEST(IdentificationFile, keepsTheTimingOfTheLoopThatWasMeasured) {
    const auto file = parseIdentification(written(header(), result()), "model.json");
    ASSERT_TRUE(file) << file.error().message;
    EXPECT_EQ(file->result.timing, (MeasuredTiming{0.01, 1}));
    EXPECT_EQ(motorEstimate(file->result).timing, file->result.timing);
    IdentifyResult unknown = result(); // a recording of another program
    unknown.timing = {};
    const auto other = parseIdentification(written(header(), unknown), "model.json");
    ASSERT_TRUE(other) << other.error().message;
    EXPECT_EQ(other->result.timing, MeasuredTiming{});
}

TEST(IdentificationFile, aRefusedOrDamagedModelIsRefusedAsEverywhere) {
    IdentifyResult refused = result();
    refused.quality.verdict = Verdict::Refused;
    const auto file = parseIdentification(written(header(), refused), "model.json");
    ASSERT_FALSE(file);
    EXPECT_EQ(file.error().code, ErrorCode::Refused);
    const std::string text = written(header(), result());
    EXPECT_FALSE(parseIdentification(text.substr(0, text.size() / 2), "model.json"));
    EXPECT_FALSE(readIdentificationFile("/nowhere/model.json"));
}

} // namespace
} // namespace halbench::app
