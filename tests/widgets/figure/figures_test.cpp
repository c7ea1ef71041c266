#include "control/base/unit_text.h"
#include "widgets/figure/figure_scales.h"
#include "widgets/figure/figures.h"

#include <gtest/gtest.h>

namespace halbench::widgets {
namespace {

Figure curveFigure(std::vector<double> x, std::vector<double> y, CurveStyle style = CurveStyle::Line) {
    Panel panel;
    panel.y.quantity = "value";
    panel.curves = {{"curve", std::move(x), std::move(y), style, {}}};
    Figure figure;
    figure.x.quantity = "time";
    figure.panels = {std::move(panel)};
    return figure;
}

TEST(Figures, ellipseLiesOnItsLevelOfTheQuadraticForm) {
    EllipseContent content;
    content.centre = {2.0, -1.0};
    content.covariance = {{{4.0, -1.5}, {-1.5, 1.0}}};
    content.levels = {{"95 %", 6.0}};
    const Figure figure = ellipseFigure(content);
    const Curve& curve = figure.panels.at(0).curves.at(0);
    ASSERT_GT(curve.x.size(), 100U);
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        const double u = curve.x[i] - 2.0;
        const double v = curve.y[i] + 1.0;
        // p' C^-1 p with det C = 4 - 2.25
        EXPECT_NEAR((1.0 * u * u + 2.0 * 1.5 * u * v + 4.0 * v * v) / 1.75, 6.0, 1e-12);
    }
}

TEST(Figures, regressionTellsUsedPointsFromThoseLeftOut) {
    RegressionContent content;
    content.y.unit = "rad/s";
    content.points = {{1.0, 2.0, 0.1, true}, {2.0, 9.0, 3.0, false}, {3.0, 4.0, -0.1, true}};
    content.fits = {{"fit", {1.0, 3.0}, {2.0, 4.0}, CurveStyle::Line, {}}};
    const Figure figure = regressionFigure(content);
    ASSERT_EQ(figure.panels.size(), 2U);
    const auto& fit = figure.panels[0].curves;
    ASSERT_EQ(fit.size(), 3U);
    EXPECT_EQ(fit[1].x, (std::vector<double>{1.0, 3.0}));
    EXPECT_EQ(fit[2].style, CurveStyle::HollowPoints);
    EXPECT_EQ(fit[2].y, (std::vector<double>{9.0}));
    EXPECT_EQ(figure.panels[1].y.unit, "rad/s");
    EXPECT_EQ(figure.panels[1].curves[0].y, (std::vector<double>{0.1, -0.1}));
}

TEST(Figures, bodeSharesALogarithmicFrequencyAxis) {
    BodeContent content;
    content.responses = {{"loop", {1.0, 10.0}, {20.0, 0.0}, {-90.0, -135.0}, CurveStyle::Line, {}}};
    const Figure figure = bodeFigure(content);
    EXPECT_TRUE(figure.x.isLogarithmic);
    ASSERT_EQ(figure.panels.size(), 2U);
    EXPECT_EQ(figure.panels[0].curves[0].y, (std::vector<double>{20.0, 0.0}));
    EXPECT_EQ(figure.panels[1].curves[0].y, (std::vector<double>{-90.0, -135.0}));
}

TEST(FigureScales, holdAllDataAndAtLeastThreeTicks) {
    for (const double size : {1e-7, 0.44, 3.0, 1e6}) {
        const Figure figure = curveFigure({0.0, 1.0}, {-size, size});
        const FigureScale scale = verticalScale(figure.panels[0], 120.0);
        EXPECT_LE(scale.division.lowerBound(), -size);
        EXPECT_GE(scale.division.upperBound(), size);
        EXPECT_GE(scale.division.ticks(QwtScaleDiv::MajorTick).size(), 3);
    }
}

TEST(FigureScales, areNeverEmpty) {
    for (const Figure& figure :
         {curveFigure({}, {}), curveFigure({1.0}, {0.0}), curveFigure({0.0, 0.0}, {7.0, 7.0})}) {
        EXPECT_LT(horizontalScale(figure, 800.0).division.lowerBound(),
                  horizontalScale(figure, 800.0).division.upperBound());
        const FigureScale y = verticalScale(figure.panels[0], 200.0);
        EXPECT_LT(y.division.lowerBound(), y.division.upperBound());
    }
}

TEST(FigureScales, timeEndsAtTheNextTickWhenItIsNear) {
    const FigureScale near = horizontalScale(curveFigure({0.0, 2.99}, {0.0, 1.0}), 800.0);
    EXPECT_DOUBLE_EQ(near.division.upperBound(), 3.0);
    const FigureScale far = horizontalScale(curveFigure({0.0, 2.7}, {0.0, 1.0}), 800.0);
    EXPECT_DOUBLE_EQ(far.division.upperBound(), 2.7);
}

TEST(FigureScales, refineTheWishedStepWhereItLeavesTooFewTicks) {
    Figure figure = curveFigure({0.0, 1.0}, {-255.0, -145.0});
    figure.panels[0].y.tickStep = 45.0;
    const auto narrow = verticalScale(figure.panels[0], 220.0).division.ticks(QwtScaleDiv::MajorTick);
    ASSERT_GE(narrow.size(), 3);
    EXPECT_DOUBLE_EQ(narrow[1] - narrow[0], 15.0);
    figure.panels[0].curves[0].y = {-270.0, -90.0};
    const auto wide = verticalScale(figure.panels[0], 220.0).division.ticks(QwtScaleDiv::MajorTick);
    EXPECT_DOUBLE_EQ(wide[1] - wide[0], 45.0);
    const auto low = verticalScale(figure.panels[0], 70.0).division.ticks(QwtScaleDiv::MajorTick);
    ASSERT_GE(low.size(), 2);
    EXPECT_DOUBLE_EQ(low[1] - low[0], 90.0); // too dense for 45, and 50 is no phase
}

TEST(FigureScales, obeyGivenExtents) {
    Figure figure = curveFigure({0.0, 1.0}, {0.0, 1.0});
    figure.panels[0].y.min = -20.0;
    figure.panels[0].y.max = 5.0;
    const FigureScale scale = verticalScale(figure.panels[0], 200.0);
    EXPECT_EQ(scale.division.lowerBound(), -20.0);
    EXPECT_EQ(scale.division.upperBound(), 5.0);
}

TEST(UnitText, writesProductsAndPowersAsPeopleDo) {
    EXPECT_EQ(unitText("N*m*s/rad"), "N·m·s/rad");
    EXPECT_EQ(unitText("kg*m^2"), "kg·m²");
    EXPECT_EQ(unitText("A*s^2/rad"), "A·s²/rad");
    EXPECT_EQ(unitText("A/sqrt(Hz)"), "A/√Hz");
    EXPECT_EQ(unitText("degC"), "°C");
    EXPECT_EQ(unitText("deg"), "°");
    EXPECT_EQ(unitText("A/(deg*s)"), "A/(°·s)");
    EXPECT_EQ(unitText(""), "");
}

} // namespace
} // namespace halbench::widgets
