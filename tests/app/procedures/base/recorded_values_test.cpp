#include "app/procedures/base/recorded_values.h"

#include <gtest/gtest.h>

#include <limits>

namespace halbench::app {
namespace {

constexpr double Missing = std::numeric_limits<double>::quiet_NaN();

Recording ofTimes(std::vector<double> time_s) {
    Recording recording;
    recording.time_s = std::move(time_s);
    return recording;
}

TEST(RecordedValues, theFirstMissingOneIsNamedWithItsLine) {
    const Recording recording = ofTimes({0.0, 0.01, 0.02, 0.03});
    const auto checked = checkRecordedValues(recording, "position", {0.0, 0.1, Missing, Missing});
    ASSERT_FALSE(checked);
    EXPECT_EQ(checked.error().code, ErrorCode::NotFinite);
    EXPECT_EQ(checked.error().message, "position has no value at 0.02 s (row 3, 2 such rows)");
    EXPECT_NE(checked.error().hint.find("line 4 of a CSV file"), std::string::npos) << checked.error().hint;
    EXPECT_FALSE(
        checkRecordedValues(recording, "x", {0.0, std::numeric_limits<double>::infinity(), 0.0, 0.0}));
}

TEST(RecordedValues, rowsBeforeTheFirstThatCountsMayBeMissing) {
    const Recording recording = ofTimes({0.0, 0.01, 0.02});
    EXPECT_TRUE(checkRecordedValues(recording, "position", {Missing, 0.0, 0.1}, 1));
    EXPECT_FALSE(checkRecordedValues(recording, "position", {Missing, 0.0, 0.1}));
    EXPECT_TRUE(checkRecordedValues(recording, "position", {}));
}

} // namespace
} // namespace halbench::app
