#include "widgets/figure/figure_axis.h"
#include "widgets/figure/figure_painter.h"
#include "widgets/figure/offscreen_application.h"

#include <QImage>
#include <QPainter>
#include <qwt_text.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::widgets {
namespace {

Figure twoPanels() {
    Panel panel;
    panel.y = {"value", "A", false, {}, {}, {}};
    panel.curves = {{"one", {0.0, 1.0}, {0.0, 1.0}, CurveStyle::Line, 0},
                    {"two", {0.5}, {0.5}, CurveStyle::Points, 1}};
    Panel wide = panel;
    wide.curves[0].y = {0.0, 123456.0};
    return {"Title", {"time", "s", false, {}, {}, {}}, {panel, wide}};
}

int pixelsOf(const QImage& image, const QRectF& area, const QColor& colour) {
    int count = 0;
    for (int y = static_cast<int>(area.top()); y < area.bottom(); ++y) {
        for (int x = static_cast<int>(area.left()); x < area.right(); ++x) {
            const QColor pixel = image.pixelColor(x, y);
            const bool isClose = std::abs(pixel.red() - colour.red()) +
                                     std::abs(pixel.green() - colour.green()) +
                                     std::abs(pixel.blue() - colour.blue()) <
                                 60;
            count += isClose ? 1 : 0;
        }
    }
    return count;
}

QStringList labelsOf(const FigureScale& scale) {
    const FigureAxis axis(scale, QwtScaleDraw::LeftScale, QRectF(0, 0, 1, 200));
    QStringList labels;
    for (const double tick : scale.division.ticks(QwtScaleDiv::MajorTick)) {
        labels << axis.label(tick).text();
    }
    return labels;
}

TEST(FigureLayout, alignsPanelsAndKeepsThemApart) {
    const auto application = OffscreenApplication::ensure();
    const Figure figure = twoPanels();
    const FigureLayout layout = layOut(figure, 600);
    ASSERT_EQ(layout.panels.size(), 2U);
    EXPECT_EQ(layout.panels[0].canvas.left(), layout.panels[1].canvas.left());
    EXPECT_EQ(layout.panels[0].canvas.right(), layout.panels[1].canvas.right());
    EXPECT_GT(layout.panels[1].canvas.top(), layout.panels[0].canvas.bottom());
    EXPECT_GT(layout.size.height(), layout.panels[1].canvas.bottom() + 36.0); // tick labels and title below
    EXPECT_LT(layout.panels[1].canvas.right(), 600.0);
    EXPECT_EQ(layout.panels[0].legend.size(), 2U);
    EXPECT_TRUE(layout.panels[1].legend.empty()); // the same curves are not named twice
}

TEST(FigureLayout, wrapsALegendThatIsTooLong) {
    const auto application = OffscreenApplication::ensure();
    Figure figure = twoPanels();
    figure.panels.resize(1);
    figure.panels[0].curves[0].label = std::string(60, 'w');
    figure.panels[0].curves[1].label = std::string(60, 'm');
    const FigureLayout layout = layOut(figure, 600);
    EXPECT_GT(layout.panels[0].legend[1].baseline, layout.panels[0].legend[0].baseline);
    EXPECT_GT(layout.panels[0].canvas.top(), layout.panels[0].legend[1].baseline);
}

QImage painted(const Figure& figure, const FigureLayout& layout, const Theme& theme,
               QChar decimalPoint = QLatin1Char('.')) {
    QImage image(layout.size, QImage::Format_RGB32);
    image.fill(theme.panel);
    QPainter painter(&image);
    paintFigure(painter, figure, layout, theme, decimalPoint);
    return image;
}

TEST(FigurePainter, drawsEveryCurveInItsColourInsideItsPanel) {
    const auto application = OffscreenApplication::ensure();
    const Theme theme = loadTheme("dark").value();
    const Figure figure = twoPanels();
    const FigureLayout layout = layOut(figure, 600);
    const QImage image = painted(figure, layout, theme);
    for (const FigureLayout::PanelPlace& place : layout.panels) {
        EXPECT_GT(pixelsOf(image, place.canvas, theme.curves[0]), 100); // a line across the panel
        EXPECT_GT(pixelsOf(image, place.canvas, theme.curves[1]), 10);  // one marker
        EXPECT_EQ(pixelsOf(image, place.canvas, theme.curves[2]), 0);
    }
}

TEST(FigurePainter, numbersHaveTheUsersDecimalPointAndNamesTheirOwn) {
    const auto application = OffscreenApplication::ensure();
    const Theme theme = loadTheme("light").value();
    const auto drawn = [&theme](const char* label, QChar point) {
        Figure figure = twoPanels();
        figure.panels.resize(1);
        figure.panels[0].curves = {{label, {0.0, 0.1}, {0.0, 0.1}, CurveStyle::Line, 0}};
        figure.panels[0].lines = {{ReferenceLine::Direction::Vertical, 0.05, label}};
        const FigureLayout layout = layOut(figure, 600);
        return painted(figure, layout, theme, point);
    };
    const QChar comma = QLatin1Char(',');
    EXPECT_EQ(drawn("limit ±1.7°", comma), drawn("limit ±1,7°", comma));
    EXPECT_NE(drawn("limit ±1.7°", comma), drawn("limit ±1.7°", QLatin1Char('.')));
    EXPECT_NE(drawn("run_2.5", comma), drawn("run_2,5", comma));
    FigureAxis axis({QwtScaleDiv(0.0, 1.0, {}, {}, {0.0, 0.5, 1.0}), false}, QwtScaleDraw::LeftScale, {});
    axis.setDecimalPoint(comma);
    EXPECT_EQ(axis.label(0.5).text(), QStringLiteral("0,5"));
}

TEST(FigurePainter, aDashedLineOfManyPointsHasItsGaps) {
    const auto application = OffscreenApplication::ensure();
    const Theme theme = loadTheme("light").value();
    const auto inked = [&theme](CurveStyle style) {
        Figure figure = twoPanels();
        figure.panels.resize(1);
        Curve curve{{}, {}, {}, style, 0};
        for (int i = 0; i <= 1000; ++i) { // two points in each column
            curve.x.push_back(0.001 * i);
            curve.y.push_back(0.001 * i);
        }
        figure.panels[0].curves = {curve};
        const FigureLayout layout = layOut(figure, 600);
        return pixelsOf(painted(figure, layout, theme), layout.panels[0].canvas, theme.curves[0]);
    };
    // Qt's dashes are four widths long and two apart: a third of the line is left out.
    EXPECT_LT(inked(CurveStyle::DashedLine), 0.85 * inked(CurveStyle::Line));
    EXPECT_LT(inked(CurveStyle::DashDotLine), 0.85 * inked(CurveStyle::Line));
}

TEST(FigurePainter, noLineRunsThroughALabel) {
    const auto application = OffscreenApplication::ensure();
    const Theme theme = loadTheme("light").value();
    Figure figure = twoPanels();
    figure.panels.resize(1);
    using Direction = ReferenceLine::Direction;
    // No room to the right of its line, and the other line everywhere to the left; blanks have no pixels.
    figure.panels[0].curves = {{{}, {0.0, 1.0}, {0.0, 1.0}, CurveStyle::Line, 0}};
    figure.panels[0].lines = {{Direction::Vertical, 0.90, {}},
                              {Direction::Vertical, 0.99, std::string(30, ' ') + "."}};
    const FigureLayout layout = layOut(figure, 600);
    const QImage image = painted(figure, layout, theme);
    const QRectF& canvas = layout.panels[0].canvas;
    const double at_px = canvas.left() + 0.90 * canvas.width();
    const QRectF column(at_px - 3.0, canvas.top() + 2.0, 6.0, canvas.height() - 4.0);
    int longestGap_px = 0;
    int gap_px = 0;
    for (int row = 0; row < static_cast<int>(column.height()); ++row) {
        const QRectF pixels(column.left(), column.top() + row, column.width(), 1.0);
        gap_px = pixelsOf(image, pixels, theme.muted) > 0 ? 0 : gap_px + 1;
        longestGap_px = std::max(longestGap_px, gap_px);
    }
    EXPECT_GE(longestGap_px, 10); // a label is 14 high, the gap between two dashes is less than 5
    EXPECT_LE(longestGap_px, 20); // and the line is there elsewhere
}

TEST(FigureAxis, labelsOfOneAxisHaveTheSameDecimals) {
    const auto application = OffscreenApplication::ensure();
    Panel panel;
    panel.curves = {{{}, {0.0, 1.0}, {0.0195, 0.0215}, CurveStyle::Line, {}}};
    for (const QString& label : labelsOf(verticalScale(panel, 200.0))) {
        EXPECT_EQ(label.section(QLatin1Char('.'), 1).size(), 4) << label.toStdString();
    }
}

TEST(FigureAxis, neverShowsANegativeZeroAndKeepsExtremesShort) {
    const auto application = OffscreenApplication::ensure();
    Panel panel;
    panel.curves = {{{}, {0.0, 1.0}, {-0.41, 0.42}, CurveStyle::Line, {}}};
    EXPECT_FALSE(labelsOf(verticalScale(panel, 120.0)).contains(QStringLiteral("-0.0")));
    EXPECT_TRUE(labelsOf(verticalScale(panel, 120.0)).contains(QStringLiteral("0.0")));
    panel.curves[0].y = {0.0, 3e-9};
    for (const QString& label : labelsOf(verticalScale(panel, 120.0))) {
        EXPECT_LE(label.size(), 7) << label.toStdString();
    }
}

TEST(FigurePainter, aBandIsFilledBehindItsCurveAndDoesNotStretchTheAxis) {
    const auto application = OffscreenApplication::ensure();
    Figure figure = twoPanels();
    figure.panels.resize(1);
    Panel& panel = figure.panels.front();
    panel.curves = {{"one", {0.0, 1.0}, {0.0, 1.0}, CurveStyle::Line, 1}};
    const FigureScale plain = verticalScale(panel, 200.0);
    panel.curves.push_back(
        {"5-95 % band", {0.0, 1.0, 1.0, 0.0}, {0.3, 1e30, 0.7, -0.3}, CurveStyle::Band, 0});
    EXPECT_EQ(verticalScale(panel, 200.0).division.upperBound(), plain.division.upperBound());
    const FigureLayout layout = layOut(figure, 600);
    EXPECT_EQ(layout.panels[0].legend.size(), 2U);
    QImage image(layout.size, QImage::Format_ARGB32_Premultiplied);
    const Theme theme = *loadTheme("light");
    image.fill(theme.panel);
    QPainter painter(&image);
    paintFigure(painter, figure, layout, theme);
    painter.end();
    const QRectF canvas = layout.panels[0].canvas;
    const auto shade = [&](double x, double y) {
        return image.pixelColor(
            QPointF(canvas.left() + x * canvas.width() + 3.0, canvas.bottom() - y * canvas.height() + 3.0)
                .toPoint());
    };
    // Above the curve in the middle everything is band, up to the frame; below its lower edge nothing is.
    EXPECT_NE(shade(0.5, 0.8), theme.plotBackground);
    EXPECT_EQ(shade(0.5, 0.1), theme.plotBackground);
    EXPECT_LT(std::abs(shade(0.5, 0.8).lightness() - theme.plotBackground.lightness()), 60); // faint
}

} // namespace
} // namespace halbench::widgets
