#include "app/workspaces/recordings/overlay_figure.h"
#include "tests/app/experiments/compared_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

OverlayView viewOf(const std::string& signal, double factor = 1.0, std::size_t columns = 4000) {
    OverlayView view;
    view.signal = signal;
    view.factor = factor;
    view.columns = columns;
    return view;
}

long gapsIn(const widgets::Curve& curve) {
    return std::count_if(curve.y.begin(), curve.y.end(), [](double y) { return std::isnan(y); });
}

TEST(OverlayFigure, curvesBeginAtTheirMomentAndBreakAtGaps) {
    ComparedRun late = runOf("late", 7.0);
    for (std::size_t row = 50; row < 100; ++row) {
        late.recording.time_s[row] += 1.0;
    }
    const widgets::Figure figure = overlayFigure({runOf("early", 0.0), late}, viewOf("position", 1000.0));
    ASSERT_EQ(figure.panels.size(), 1U);
    const auto& curves = figure.panels[0].curves;
    ASSERT_EQ(curves.size(), 2U);
    EXPECT_EQ(curves[0].label, "early");
    for (const widgets::Curve& curve : curves) {
        EXPECT_EQ(curve.x.front(), 0.0);
        EXPECT_EQ(curve.x.size(), curve.y.size());
    }
    EXPECT_NEAR(curves[1].y.front(), 7000.0, 1e-6);
    EXPECT_EQ(gapsIn(curves[1]), 1);
    EXPECT_EQ(gapsIn(curves[0]), 0);
}

TEST(OverlayFigure, noSpikeIsLostInALongRun) {
    ComparedRun run = runOf("a", 0.0);
    run.recording.time_s.clear();
    run.recording.values.clear();
    for (int row = 0; row < 100000; ++row) {
        run.recording.time_s.push_back(row * 0.01);
        run.recording.values.insert(run.recording.values.end(), {row == 54321 ? 9.0 : 0.0, 1.0});
    }
    const widgets::Figure figure = overlayFigure({run}, viewOf("position", 1.0, 500));
    const auto& curve = figure.panels[0].curves[0];
    EXPECT_LE(curve.x.size(), 4U * 500U);
    EXPECT_EQ(*std::max_element(curve.y.begin(), curve.y.end()), 9.0);
}

TEST(OverlayFigure, aSpanShowsItsRowsOnly) {
    OverlayView view = viewOf("position");
    view.span_s = {0.195, 0.405}; // of rows every 10 ms: 0.20 ... 0.40
    const widgets::Figure figure = overlayFigure({runOf("a", 5.0)}, view);
    const auto& curve = figure.panels[0].curves[0];
    EXPECT_EQ(curve.x.size(), 21U);
    EXPECT_NEAR(curve.x.front(), 0.20, 1e-9);
    EXPECT_NEAR(curve.x.back(), 0.40, 1e-9);
    EXPECT_EQ(figure.x.min, 0.195);
    EXPECT_EQ(figure.x.max, 0.405);
    view.span_s = {2.0, 3.0};
    EXPECT_TRUE(overlayFigure({runOf("a", 5.0)}, view).panels.empty()) << "nothing was recorded then";
}

TEST(OverlayFigure, aRunKeepsItsColourWhenOthersAreLeftOut) {
    ComparedRun marked = runOf("b", 0.0);
    marked.meta.markers = {{0.5, "trigger"}};
    OverlayView view = viewOf("position");
    view.alignment.moment = RunAlignment::Moment::Trigger;
    const widgets::Figure figure = overlayFigure({runOf("a", 0.0), marked}, view);
    ASSERT_EQ(figure.panels[0].curves.size(), 1U);
    EXPECT_EQ(figure.panels[0].curves[0].colour, 1);
    EXPECT_TRUE(overlayFigure({runOf("a", 0.0)}, view).panels.empty());
    const std::vector<ComparedRun> many(9, runOf("a", 0.0));
    const auto curves = overlayFigure(many, viewOf("position")).panels[0].curves;
    EXPECT_EQ(curves[8].colour, 0);
    EXPECT_EQ(curves[8].style, widgets::CurveStyle::DashedLine) << "the ninth looks like no other";
}

} // namespace
} // namespace halbench::app
