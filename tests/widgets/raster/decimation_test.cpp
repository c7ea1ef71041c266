#include "widgets/raster/decimation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace halbench::widgets {
namespace {

TEST(Decimation, keepsShortCurvesAsTheyAre) {
    const std::vector<double> x = {0.0, 1.0, 2.0};
    const std::vector<double> y = {5.0, 4.0, 6.0};
    const auto lines = decimated(x, y, 0.0, 2.0, 100);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0], (Polyline{{0.0, 5.0}, {1.0, 4.0}, {2.0, 6.0}}));
}

TEST(Decimation, losesNoSingleSpikeAndNoMoreThanTwoPointsAColumn) {
    std::vector<double> x;
    std::vector<double> y;
    for (int i = 0; i < 100000; ++i) {
        x.push_back(i);
        y.push_back(i == 31415 ? 1000.0 : i == 77777 ? -500.0 : std::sin(0.01 * i));
    }
    const auto lines = decimated(x, y, 0.0, 99999.0, 1600);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_LE(lines[0].size(), 2U * 1601U);
    EXPECT_NE(std::find(lines[0].begin(), lines[0].end(), std::pair(31415.0, 1000.0)), lines[0].end());
    EXPECT_NE(std::find(lines[0].begin(), lines[0].end(), std::pair(77777.0, -500.0)), lines[0].end());
    EXPECT_TRUE(std::is_sorted(lines[0].begin(), lines[0].end()));
}

TEST(Decimation, breaksTheLineWhereAValueIsMissing) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto lines = decimated({0, 1, 2, 3, 4}, {nan, 1, nan, nan, 2}, 0.0, 4.0, 10);
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_EQ(lines[0], (Polyline{{1.0, 1.0}}));
    EXPECT_EQ(lines[1], (Polyline{{4.0, 2.0}}));
    EXPECT_TRUE(decimated({}, {}, 0.0, 1.0, 10).empty());
}

TEST(Decimation, leavesClosedCurvesAlone) {
    std::vector<double> x;
    std::vector<double> y;
    for (int i = 0; i < 500; ++i) {
        x.push_back(std::cos(0.0126 * i));
        y.push_back(std::sin(0.0126 * i));
    }
    EXPECT_EQ(decimated(x, y, -1.0, 1.0, 10).at(0).size(), 500U);
}

} // namespace
} // namespace halbench::widgets
