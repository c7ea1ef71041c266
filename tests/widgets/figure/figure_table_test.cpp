#include "widgets/figure/figure_table.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::widgets {
namespace {

TEST(FigureTable, hasAColumnPerCurveAndOneForTheSharedAxis) {
    Figure figure;
    figure.x = {"frequency", "Hz", true, {}, {}, {}};
    Panel magnitude;
    magnitude.y = {"magnitude", "dB", false, {}, {}, {}};
    magnitude.curves = {{"proposed", {1.0, 10.0}, {0.1, NAN}, CurveStyle::Line, 0},
                        {"a, b", {1.0, 10.0}, {2.0, 3.0}, CurveStyle::Line, 1},
                        {"measured", {4.0}, {-1.0 / 3.0}, CurveStyle::Points, 6}};
    figure.panels = {magnitude};
    EXPECT_EQ(figureTable(figure), "frequency [Hz],proposed magnitude [dB],\"a, b magnitude [dB]\","
                                   "measured frequency [Hz],measured magnitude [dB]\n"
                                   "1,0.1,2,4,-0.3333333333333333\n"
                                   "10,,3,,\n");
}

TEST(FigureTable, aBandHasItsTwoEdgesAndAPlaneItsParameter) {
    Figure figure;
    figure.x = {"time", "s", false, {}, {}, {}};
    Panel panel;
    panel.y = {"angle", "deg", false, {}, {}, {}};
    panel.curves = {{"motors", {0.0, 1.0, 1.0, 0.0}, {5.0, 6.0, 2.0, 1.0}, CurveStyle::Band, 0}};
    figure.panels = {panel};
    EXPECT_EQ(figureTable(figure), "time [s],motors angle p5 [deg],motors angle p95 [deg]\n"
                                   "0,1,5\n"
                                   "1,2,6\n");
    figure.parameter = Axis{"frequency", "Hz", true, {}, {}, {}};
    figure.panels[0].curves = {{"", {0.5}, {0.25}, CurveStyle::Line, 0, false, {8.0}}};
    EXPECT_EQ(figureTable(figure), "time [s],frequency [Hz],angle [deg]\n0.5,8,0.25\n");
}

} // namespace
} // namespace halbench::widgets
