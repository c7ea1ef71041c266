#include "app/figures/analysis_figure.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

AnalysisPlot plotOver(const char* x, const char* y) {
    AnalysisPlot plot;
    plot.title = std::string(y) + " over " + x;
    plot.x = {x, "s"};
    plot.panels.push_back({{y, "T", true}, {{"one", {0.0, 1.0}, {2.0, 3.0}, true}}, 2.5});
    return plot;
}

TEST(AnalysisFigureTest, hasTheCurvesAndTheLimitOfThePlot) {
    const widgets::Figure figure = analysisFigure(plotOver("time", "field"));
    EXPECT_EQ(figure.title, "field over time");
    EXPECT_EQ(figure.x.quantity, "time");
    ASSERT_EQ(figure.panels.size(), 1U);
    EXPECT_TRUE(figure.panels[0].y.isLogarithmic);
    EXPECT_EQ(figure.panels[0].curves.at(0).style, widgets::CurveStyle::Points);
    EXPECT_EQ(figure.panels[0].curves.at(0).y.at(1), 3.0);
    EXPECT_EQ(figure.panels[0].lines.at(0).at, 2.5);
    EXPECT_FALSE(figure.isEqualScale);
}

TEST(AnalysisFigureTest, aPictureHasThePlotsOverTheSameAxis) {
    AnalysisPlot path = plotOver("time", "path");
    path.isEqualScale = true; // stands alone
    const widgets::Figure picture = analysisPicture(
        {plotOver("time", "field"), plotOver("iteration", "fitness"), path, plotOver("time", "error")});
    EXPECT_EQ(picture.title, "field over time");
    ASSERT_EQ(picture.panels.size(), 2U);
    EXPECT_EQ(picture.panels[1].y.quantity, "error");
    EXPECT_TRUE(analysisPicture({path}).isEqualScale);
}

} // namespace
} // namespace halbench::app
