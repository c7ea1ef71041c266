#include "tests/control/history/history_blocks.h"
#include "widgets/raster/curve_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace halbench::widgets {
namespace {

using control::SampleHistory;

/// `columns` over [0, columns] hundredths of a second; one unit is one row, zero in row 100.
PixelMap mapOf(int columns, double columnsPerSecond) {
    PixelMap map;
    map.perSecond = columnsPerSecond;
    map.zero = 100.0;
    map.columns = columns;
    map.rows = 200;
    return map;
}

SampleHistory historyOf(const std::vector<double>& values, double period_s) {
    SampleHistory history(std::size_t{1} << 26);
    history.append(control::blockOf(control::layoutOf({"a"}, period_s), 0, values.size(),
                                    [&](std::size_t row, std::size_t) { return values[row]; }));
    return history;
}

CurveShape shapeOf(const SampleHistory& history, const PixelMap& map, double end_s) {
    CurveShape shape;
    shapeCurve(history, "a", {0.0, end_s}, map, 6.0, shape);
    return shape;
}

TEST(CurveShape, sparseSamplesAreALineThroughTheCentresOfTheirPixels) {
    const CurveShape shape = shapeOf(historyOf({1.0, 3.0, 2.0}, 0.1), mapOf(100, 100.0), 1.0);
    ASSERT_EQ(shape.lineCount, 1U);
    ASSERT_EQ(shape.lines[0].size(), 3U);
    EXPECT_DOUBLE_EQ(shape.lines[0][1].x, 10.5);
    EXPECT_DOUBLE_EQ(shape.lines[0][1].y, 97.0);
    EXPECT_TRUE(shape.areSamplesMarked);
    EXPECT_TRUE(shape.boxes.empty());
}

TEST(CurveShape, aBreakEndsALine) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const CurveShape shape = shapeOf(historyOf({1.0, 3.0, nan, 2.0, 2.0}, 0.1), mapOf(100, 100.0), 1.0);
    ASSERT_EQ(shape.lineCount, 2U);
    EXPECT_EQ(shape.lines[0].size(), 2U);
    EXPECT_EQ(shape.lines[1].size(), 2U);
}

TEST(CurveShape, denseSamplesAreTheExtremesOfTheColumnWithTheNearestCentre) {
    std::vector<double> values(1000, 0.0);
    values[555] = 50.0; // at 0.555 s: column 55.5, so of the centres at 55 and 56 ... the edge between them
    values[333] = -20.0;
    const CurveShape shape = shapeOf(historyOf(values, 0.001), mapOf(100, 100.0), 1.0);
    ASSERT_EQ(shape.boxes.size(), 100U);
    EXPECT_DOUBLE_EQ(shape.boxes[33].bottom, 120.0);
    const auto spike = std::min_element(shape.boxes.begin(), shape.boxes.end(),
                                        [](const PixelBox& l, const PixelBox& r) { return l.top < r.top; });
    EXPECT_DOUBLE_EQ(spike->top, 50.0);
    EXPECT_TRUE(spike->column == 55 || spike->column == 56);
}

TEST(CurveShape, neighbouringColumnsMeetHalfOfTheWay) {
    std::vector<double> values(1000, 0.0);
    std::fill(values.begin() + 505, values.end(), 40.0); // a step at the edge of columns 50 and 51
    const CurveShape shape = shapeOf(historyOf(values, 0.001), mapOf(100, 100.0), 1.0);
    for (std::size_t i = 1; i < shape.boxes.size(); ++i) {
        EXPECT_LE(shape.boxes[i].top, shape.boxes[i - 1].bottom) << i;
        EXPECT_GE(shape.boxes[i].bottom, shape.boxes[i - 1].top) << i;
    }
}

TEST(CurveShape, nothingIsJoinedAcrossAGap) {
    SampleHistory history(std::size_t{1} << 26);
    const auto layout = control::layoutOf({"a"}, 0.001);
    const auto zero = [](std::size_t, std::size_t) { return 0.0; };
    history.append(control::blockOf(layout, 0, 400, zero));
    SampleBlock late = control::blockOf(layout, 600, 400, zero);
    late.lostRows = 200;
    history.append(late);
    const CurveShape shape = shapeOf(history, mapOf(100, 100.0), 1.0);
    const auto breaks = std::count_if(shape.boxes.begin(), shape.boxes.end(),
                                      [](const PixelBox& box) { return !box.isJoined; });
    EXPECT_EQ(breaks, 2); // the first of all and the first after the gap
    EXPECT_LT(shape.boxes.size(), 85U);
}

TEST(CurveShape, nothingIsShownAfterThePause) {
    const SampleHistory history = historyOf(std::vector<double>(1000, 0.0), 0.001);
    const CurveShape dense = shapeOf(history, mapOf(100, 100.0), 0.5);
    EXPECT_LE(dense.boxes.back().column, 51);
    const CurveShape sparse = shapeOf(history, mapOf(100, 2000.0), 0.02);
    EXPECT_LE(sparse.lines[0].back().x, 42.0);
}

TEST(CurveShape, farAwayValuesStayCountable) {
    const CurveShape shape = shapeOf(historyOf({1e300, -1e300}, 0.1), mapOf(100, 100.0), 1.0);
    EXPECT_TRUE(std::isfinite(shape.lines[0][0].y));
    EXPECT_LT(std::abs(shape.lines[0][1].y), 1e5);
}

} // namespace
} // namespace halbench::widgets
