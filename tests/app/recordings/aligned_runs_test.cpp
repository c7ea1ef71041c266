#include "app/recordings/aligned_runs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace halbench::app {
namespace {

/// Rows at a rate from a time on; the position is a line, the status counts the rows.
ComparedRun runOf(const std::string& name, double from_s, double slope, double rate_Hz = 10.0,
                  std::size_t rows = 11) {
    ComparedRun run;
    run.name = name;
    run.recording.layout = std::make_shared<const StreamLayout>(
        StreamLayout{{{"position", "rad"}, {"status", ""}}, 1.0 / rate_Hz});
    for (std::size_t row = 0; row < rows; ++row) {
        run.recording.time_s.push_back(from_s + static_cast<double>(row) / rate_Hz);
        run.recording.values.insert(run.recording.values.end(),
                                    {slope * static_cast<double>(row) / rate_Hz, static_cast<double>(row)});
    }
    return run;
}

TEST(AlignedRuns, aMomentIsCalledByItsName) {
    EXPECT_EQ(alignmentNamed("start")->moment, RunAlignment::Moment::Start);
    EXPECT_EQ(alignmentNamed("trigger")->moment, RunAlignment::Moment::Trigger);
    EXPECT_EQ(alignmentNamed("marker:a: b")->marker, "a: b");
    for (const char* wrong : {"", "marker:", "end", "marker"}) {
        EXPECT_EQ(alignmentNamed(wrong).error().code, ErrorCode::Usage) << wrong;
    }
}

TEST(AlignedRuns, labelsAreDistinctPartsOfNames) {
    const std::vector<ComparedRun> runs = {runOf("a,b", 0, 0), runOf("a b", 0, 0), runOf("a_b-2", 0, 0),
                                           runOf("kühl-1", 0, 0)};
    EXPECT_EQ(runLabels(runs), (std::vector<std::string>{"a_b", "a_b-2", "a_b-2-2", "kühl-1"}));
}

TEST(AlignedRuns, samplesOnTheAxisKeepTheirValueAndTimesAreDecimal) {
    const auto all = onOneAxis({runOf("one", 0.0, 1.0), runOf("two", 7.0, 3.0)}, {});
    ASSERT_TRUE(all) << all.error().message;
    ASSERT_EQ(all->rows(), 11U);
    EXPECT_EQ(all->layout->columns[2].name, "two.position");
    EXPECT_EQ(all->layout->columns[2].unit, "rad");
    for (std::size_t row = 0; row < 11; ++row) {
        EXPECT_EQ(all->time_s[row], static_cast<double>(row) / 10.0);
        EXPECT_EQ(all->values[4 * row], static_cast<double>(row) / 10.0);
        EXPECT_EQ(all->values[4 * row + 2], 3.0 * static_cast<double>(row) / 10.0);
        EXPECT_EQ(all->values[4 * row + 3], static_cast<double>(row));
    }
}

TEST(AlignedRuns, betweenTwoSamplesLiesALineAndAStateIsThatOfTheNearer) {
    ComparedRun coarse = runOf("coarse", 0.0, 2.0, 10.0, 3);
    const auto all = onOneAxis({runOf("fine", 0.0, 1.0, 40.0, 9), coarse}, {});
    ASSERT_TRUE(all) << all.error().message;
    ASSERT_EQ(all->rows(), 9U);
    for (std::size_t row = 0; row < 9; ++row) {
        EXPECT_NEAR(all->values[4 * row + 2], 2.0 * static_cast<double>(row) / 40.0, 1e-15);
    }
    EXPECT_EQ(all->values[4 * 1 + 3], 0.0);
    EXPECT_EQ(all->values[4 * 3 + 3], 1.0);
}

TEST(AlignedRuns, nothingIsMadeUpOutsideARunInItsGapsOrBesideAMissingValue) {
    ComparedRun gap = runOf("gap", 0.2, 1.0);
    gap.recording.time_s.resize(6);
    gap.recording.values.resize(12);
    gap.recording.time_s[3] = 0.85; // 0.4 s, then 0.85, 0.95, 1.05 s
    gap.recording.time_s[4] = 0.95;
    gap.recording.time_s[5] = 1.05;
    gap.recording.values[2 * 4] = std::numeric_limits<double>::quiet_NaN();
    gap.meta.markers = {{0.0, "here"}};
    ComparedRun whole = runOf("whole", 0.0, 1.0, 10.0, 12);
    whole.meta.markers = gap.meta.markers;
    OverlayRequest request;
    request.alignment = {RunAlignment::Moment::Marker, "here"};
    const auto all = onOneAxis({whole, gap}, request);
    ASSERT_TRUE(all) << all.error().message;
    const auto has = [&](std::size_t row) { return std::isfinite(all->values[4 * row + 2]); };
    const std::vector<bool> expected = {false, false, true,  true,  true,  false,
                                        false, false, false, false, false, false};
    for (std::size_t row = 0; row < expected.size(); ++row) {
        EXPECT_EQ(has(row), expected[row]) << all->time_s[row];
    }
}

TEST(AlignedRuns, aSpanCountsFromTheMoment) {
    ComparedRun run = runOf("a", 3.0, 1.0);
    run.meta.markers = {{3.5, "trigger"}};
    OverlayRequest request{{RunAlignment::Moment::Trigger, {}}, -0.2, 0.3};
    const auto all = onOneAxis({run, run}, request);
    ASSERT_TRUE(all) << all.error().message;
    EXPECT_EQ(all->time_s, (std::vector<double>{-0.2, -0.1, 0.0, 0.1, 0.2, 0.3}));
    EXPECT_NEAR(all->values[4 * 2], 0.5, 1e-15);
    request = {{RunAlignment::Moment::Trigger, {}}, 0.31, 0.39};
    EXPECT_EQ(onOneAxis({run, run}, request).error().code, ErrorCode::OutOfRange);
    request = {{RunAlignment::Moment::Trigger, {}}, 0.0, 1e12};
    EXPECT_EQ(onOneAxis({run, run}, request).error().code, ErrorCode::OutOfRange) << "too many rows";
    request = {{RunAlignment::Moment::Marker, "none"}, {}, {}};
    const auto refused = onOneAxis({run, run}, request);
    EXPECT_EQ(refused.error().code, ErrorCode::InvalidInput);
    EXPECT_NE(refused.error().hint.find("'trigger'"), std::string::npos) << refused.error().hint;
}

TEST(AlignedRuns, theDifferenceIsThatOfTheRowsThatHaveBoth) {
    Recording both;
    both.layout =
        std::make_shared<const StreamLayout>(StreamLayout{{{"a", "rad"}, {"b", "rad"}, {"c", "rad"}}, 1.0});
    const double none = std::numeric_limits<double>::quiet_NaN();
    both.time_s = {0.0, 1.0, 2.0, 3.0};
    both.values = {1.0, 2.0, none, 1.0, -2.0, none, none, 9.0, none, 1.0, 1.0, none};
    const ColumnDifference difference = differenceBetween(both, 0, 1);
    EXPECT_EQ(difference.rows, 3U); // 1, -3 and 0
    EXPECT_NEAR(difference.mean, -2.0 / 3.0, 1e-15);
    EXPECT_NEAR(difference.rms, std::sqrt(10.0 / 3.0), 1e-15);
    EXPECT_EQ(difference.largest, -3.0);
    EXPECT_EQ(difference.largestAt_s, 1.0);
    EXPECT_EQ(differenceBetween(both, 0, 2).rows, 0U);
}

} // namespace
} // namespace halbench::app
