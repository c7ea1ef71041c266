#include "app/documents/calibration_file.h"
#include "app/documents/result_documents.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

CalibrationRecord record() {
    CalibrationRecord made;
    made.header.schema = "halbench.calibration/1";
    made.header.device = devices::DeviceInfo{"", "htm", "htm-0042", "FW", "", false, {}};
    made.header.started = "2026-05-04T03:02:01Z";
    made.header.software = "0.9.0";
    // Members of a JSON object come back in the order of their names.
    made.result.figures = {
        {"hall.offset_a", "T", {1e-4, std::pair(9e-5, 1.1e-4), control::EstimateSource::Identified, "T"}},
        {"zero.friction", "A", {std::nullopt, std::nullopt, control::EstimateSource::NotIdentifiable, "A"}}};
    made.result.before = {{"hall.offset_a", 0.0}};
    made.result.proposed = {{"hall.offset_a", 1e-4}};
    made.result.isApplied = true;
    made.result.residualBefore_rad = 0.02;
    made.result.residualAfter_rad = 0.003;
    made.result.staticFriction = {{0.5, 1.6}, {1.5, -1.7}};
    made.result.hallPoints = {{0.15, 0.01}, {-0.02, 0.14}};
    made.result.duration_s = 61.5;
    made.result.quality = {Verdict::Doubtful, {{"few", "few points", "more"}}};
    return made;
}

std::string written(const CalibrationRecord& made) {
    return toJsonText(calibrationDocument(made.header, made.result)).value();
}

TEST(CalibrationFile, whatWasReadWritesTheSameBytesAgain) {
    const auto read = parseCalibrationRecord(written(record()), "cal.json");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(written(*read), written(record()));
}

TEST(CalibrationFile, anotherDocumentIsNone) {
    EXPECT_FALSE(parseCalibrationRecord("{\"schema\": \"halbench.gains/1\"}", "cal.json"));
    EXPECT_FALSE(parseCalibrationRecord("{", "cal.json"));
}

} // namespace
} // namespace halbench::app
