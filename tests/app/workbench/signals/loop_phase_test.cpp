#include "app/workbench/signals/loop_phase.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::app {
namespace {

using widgets::CurveStyle;

widgets::Figure bode(widgets::Curve phase) {
    widgets::Figure figure;
    figure.panels.resize(2);
    figure.panels[1].y = {"phase", "deg", false, {}, {}, 45.0};
    figure.panels[1].curves = {std::move(phase)};
    return figure;
}

TEST(LoopPhase, anAngleIsWithinHalfATurn) {
    EXPECT_EQ(wrapped_deg(-90.0), -90.0);
    EXPECT_EQ(wrapped_deg(180.0), 180.0);
    EXPECT_EQ(wrapped_deg(-180.0), 180.0);
    EXPECT_EQ(wrapped_deg(-200.0), 160.0);
    EXPECT_EQ(wrapped_deg(-540.5), 179.5);
}

// -170 to -190 degrees over one decade: the edge lies in its middle, over the logarithm.
TEST(LoopPhase, aLineIsInterruptedWhereItLeavesAndGoesOnAtTheOtherEdge) {
    const auto figure = withWrappedPhase(bode({"L", {1.0, 10.0}, {-170.0, -190.0}, CurveStyle::Line, 0}));
    const widgets::Curve& curve = figure.panels[1].curves.at(0);
    ASSERT_EQ(curve.x.size(), 5U);
    EXPECT_NEAR(curve.x[1], std::sqrt(10.0), 1e-12);
    EXPECT_EQ(curve.y[1], -180.0);
    EXPECT_TRUE(std::isnan(curve.y[2]));
    EXPECT_EQ(curve.y[3], 180.0);
    EXPECT_EQ(curve.y[4], 170.0);
    EXPECT_EQ(figure.panels[1].y.min, -180.0);
    const auto back = withWrappedPhase(bode({"L", {1.0, 10.0}, {-190.0, -170.0}, CurveStyle::Line, 0}));
    EXPECT_EQ(back.panels[1].curves.at(0).y[1], 180.0);
    EXPECT_EQ(back.panels[1].curves.at(0).y[3], -180.0);
}

TEST(LoopPhase, pointsAreNotJoinedAndABandIsInEachTurnItReaches) {
    const auto points = withWrappedPhase(bode({"m", {1.0, 10.0}, {-170.0, -190.0}, CurveStyle::Points, 6}));
    EXPECT_EQ(points.panels[1].curves.at(0).y, (std::vector<double>{-170.0, 170.0}));
    const auto bands = withWrappedPhase(
        bode({"band", {1.0, 10.0, 10.0, 1.0}, {-170.0, -180.5, -200.0, -175.0}, CurveStyle::Band, 0}));
    ASSERT_EQ(bands.panels[1].curves.size(), 2U);
    EXPECT_EQ(bands.panels[1].curves[0].y[2], 160.0);
    EXPECT_EQ(bands.panels[1].curves[1].y[0], -170.0);
    EXPECT_TRUE(bands.panels[1].curves[1].label.empty());
}

} // namespace
} // namespace halbench::app
