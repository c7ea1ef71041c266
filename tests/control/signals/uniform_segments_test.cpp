#include "control/signals/uniform_segments.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace halbench::control {
namespace {

constexpr double Nan = std::numeric_limits<double>::quiet_NaN();

using Rows = std::vector<std::pair<std::size_t, std::size_t>>;

Rows rowsOf(const UniformSegments& stretches) {
    Rows rows;
    for (const Stretch& piece : stretches.pieces) {
        rows.emplace_back(piece.begin, piece.end);
    }
    return rows;
}

TEST(UniformSegments, anUnbrokenSignalIsOnePiece) {
    const auto found = findUniformSegments(std::vector{3.0, 3.5, 4.0}, std::vector{1.0, 2.0, 3.0});
    ASSERT_TRUE(found) << found.error().message;
    EXPECT_EQ(rowsOf(*found), (Rows{{0, 3}}));
    EXPECT_EQ(found->period_s, 0.5);
    EXPECT_EQ(found->gaps, 0U);
}

TEST(UniformSegments, cutsAtGapsAndLeavesOutWhatIsNoNumber) {
    // a gap need not be a whole number of periods
    const std::vector<double> time_s = {0, 1, 2, 3, 7.3, 8.3, 9.3, 10.3, 12.3};
    const std::vector<double> values = {0, 1, Nan, 3, 4, 5, 6, INFINITY, 8};
    const auto found = findUniformSegments(time_s, values);
    ASSERT_TRUE(found) << found.error().message;
    EXPECT_EQ(rowsOf(*found), (Rows{{0, 2}, {3, 4}, {4, 7}, {8, 9}}));
    EXPECT_EQ(found->gaps, 2U);
    EXPECT_EQ(found->missingValues, 2U);
    EXPECT_EQ(found->longest(), 3U);
    EXPECT_NEAR(found->period_s, 1.0, 1e-15);
}

TEST(UniformSegments, nothingButMissingValuesHasNoPiece) {
    const auto found = findUniformSegments(std::vector{0.0, 1.0}, std::vector{Nan, Nan});
    ASSERT_TRUE(found) << found.error().message;
    EXPECT_TRUE(found->pieces.empty());
    EXPECT_EQ(found->longest(), 0U);
}

TEST(UniformSegments, roundedStampsGiveTheMeanPeriod) {
    std::vector<double> time_s;
    for (int i = 0; i < 3001; ++i) {
        time_s.push_back(std::round(i / 3000.0 * 1e5) / 1e5); // 0.33 or 0.34 ms
    }
    const auto found = findUniformSegments(time_s, std::vector<double>(3001, 1.0));
    ASSERT_TRUE(found) << found.error().message;
    EXPECT_EQ(found->pieces.size(), 1U);
    EXPECT_NEAR(found->period_s, 1.0 / 3000.0, 1e-15);
}

TEST(UniformSegments, refusesUnevenTimeNamingTheRow) {
    const auto found = findUniformSegments(std::vector{0.0, 1.0, 2.0, 3.2, 4.2}, std::vector<double>(5, 0.0));
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().code, ErrorCode::Refused);
    EXPECT_THAT(found.error().message, testing::HasSubstr("1.2 s before row 4, usually 1 s"));
    EXPECT_THAT(found.error().hint, testing::HasSubstr("resample"));
}

TEST(UniformSegments, refusesTimeThatDoesNotRise) {
    for (const double second : {0.0, -1.0, Nan}) {
        const auto found = findUniformSegments(std::vector{0.0, second, 3.0}, std::vector<double>(3, 0.0));
        ASSERT_FALSE(found);
        EXPECT_EQ(found.error().code, ErrorCode::InvalidInput);
        EXPECT_THAT(found.error().message, testing::HasSubstr("from row 1 to row 2"));
    }
}

TEST(UniformSegments, refusesASingleRow) {
    EXPECT_EQ(findUniformSegments(std::vector{0.0}, std::vector{0.0}).error().code, ErrorCode::Refused);
}

} // namespace
} // namespace halbench::control
