#include "app/wizards/live_plateaus.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::app {
namespace {

/// Rows at 100 Hz of a plateau that settles with the motor's time constant c/J.
void appendPlateau(LivePlateaus& live, double& time_s, double segment, double current_A, double steady_rad_s,
                   double dwell_s) {
    SampleBlock block;
    auto layout = std::make_shared<StreamLayout>();
    layout->columns = {{"speed", "rad/s"}, {"current_command", "A"}, {"reference.segment", ""}};
    block.layout = layout;
    for (int i = 0; i < static_cast<int>(100.0 * dwell_s); ++i) {
        block.time_s.push_back(time_s);
        block.values.insert(block.values.end(),
                            {steady_rad_s * (1.0 - std::exp(-2.236 * 0.01 * i)), current_A, segment});
        time_s += 0.01;
    }
    live.take(block);
}

TEST(LivePlateaus, countsWhatHasSettledAndNothingElse) {
    LivePlateaus live;
    double time_s = 0.0;
    appendPlateau(live, time_s, 0, 4.0, 30.0, 6.0); // settled: e^(-2.236 * 5) = 1e-5 of it is left
    appendPlateau(live, time_s, 1, 3.0, 18.0, 1.5); // too short
    appendPlateau(live, time_s, 2, -3.0, -18.0, 6.0);
    appendPlateau(live, time_s, 3, 0.0, 0.0, 6.0); // coast-down
    appendPlateau(live, time_s, 4, 2.0, 7.0, 6.0); // still running: not counted yet
    const auto points = live.points();
    ASSERT_EQ(points.size(), 2U);
    EXPECT_EQ(points[0].current_A, 4.0);
    EXPECT_NEAR(points[0].speed_rad_s, 30.0, 30.0 * 1e-4); // what is left after 5 s
    EXPECT_EQ(points[1].current_A, -3.0);
    EXPECT_NEAR(live.elapsed_s(), 25.5 - 0.01, 1e-9);
}

TEST(LivePlateaus, aStreamWithoutItsColumnsIsLeftAlone) {
    LivePlateaus live;
    SampleBlock block;
    auto layout = std::make_shared<StreamLayout>();
    layout->columns = {{"speed", "rad/s"}};
    block.layout = layout;
    block.time_s = {0.0};
    block.values = {1.0};
    live.take(block);
    EXPECT_TRUE(live.points().empty());
}

TEST(LivePlateaus, theLineOfEachDirectionBeginsAtItsBreakawayCurrent) {
    // s omega = (|I| - 1.4 A)/0.1
    const auto figure = livePlateauFigure({{2.0, 6.0}, {4.0, 26.0}, {-3.0, -16.0}}, 4.0, 40.0);
    const auto& curves = figure.panels.at(0).curves;
    ASSERT_EQ(curves.size(), 2U); // one point decides no line
    EXPECT_NEAR(curves[0].x.front(), 1.4, 1e-12);
    EXPECT_NEAR(curves[0].y.front(), 0.0, 1e-12);
    EXPECT_NEAR(curves[0].y.back(), 26.0, 1e-12);
    EXPECT_EQ(curves[1].x.size(), 3U);
}

} // namespace
} // namespace halbench::app
