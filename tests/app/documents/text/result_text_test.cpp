#include "app/documents/text/result_text.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

TEST(ResultText, findingsFollowTheVerdictALineEach) {
    const DataQuality quality{Verdict::Doubtful, {{"few_rows", "10 rows only", "record longer"}}};
    EXPECT_EQ(findingLines(quality), "data quality: doubtful\n  few_rows: 10 rows only; record longer\n");
    EXPECT_EQ(findingLines({}), "data quality: good\n");
}

TEST(ResultText, aFigureHasTheUnitThatItsNameEndsWith) {
    JsonValue figures = JsonValue::object();
    figures.set("rise_time_s", 0.25).set("top_speed_rad_s", 12.0).set("lock_time_s", JsonValue());
    figures.set("ramp_end_speed_m_s", 0.005).set("parts", JsonValue::object());
    EXPECT_EQ(figureLines("step", figures), "step\n"
                                            "  rise time                0.25 s\n"
                                            "  top speed                12 rad/s\n"
                                            "  lock time                none\n"
                                            "  ramp end speed           0.005 m/s\n");
}

TEST(ResultText, anEstimateShowsItsIntervalAndSource) {
    control::Estimate estimate{0.00123, std::pair(0.0012, 0.00126), control::EstimateSource::Identified, "A"};
    EXPECT_EQ(estimateLine("c", estimate), "c              0.00123 A  [0.0012, 0.00126]  identified\n");
    EXPECT_EQ(estimateLine("c", {}).substr(0, 15), "c              ")
        << "no number that the data do not hold";
    EXPECT_EQ(estimateLine("c", {}).find("0.00"), std::string::npos);
}

} // namespace
} // namespace halbench::app
