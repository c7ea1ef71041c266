#include "tests/widgets/gui_fixture.h"
#include "widgets/figure/curve_layers.h"
#include "widgets/figure/figure_view.h"
#include "widgets/figure/panel_layers.h"
#include "widgets/theme/theme_style.h"

#include <QPainter>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace halbench::widgets {
namespace {

/// Three curves that cross each other, the second a band; `phase` moves the first, the others stay.
Figure figure(double phase, double amplitude = 1.0) {
    Figure made;
    made.x = {"time", "s", false, 0.0, 10.0, {}};
    Panel panel;
    panel.y = {"angle", "deg", false, -1.5, 1.5, {}};
    panel.lines = {{ReferenceLine::Direction::Vertical, 3.0, "here"}};
    panel.curves.resize(4);
    for (int i = 0; i <= 600; ++i) {
        const double x = i / 60.0;
        const double y[] = {std::sin(x + phase), 0.3 + 0.1 * x, amplitude * std::cos(3.0 * x),
                            std::sin(9.0 * x)};
        for (std::size_t k = 0; k < 4; ++k) {
            panel.curves[k].x.push_back(x);
            panel.curves[k].y.push_back(y[k]);
        }
    }
    panel.curves[1].style = CurveStyle::Band;
    panel.curves[3].style = CurveStyle::DashedLine;
    made.panels = {panel, panel};
    std::rotate(made.panels[1].curves.begin(), made.panels[1].curves.begin() + 1,
                made.panels[1].curves.end()); // there what moves is above what stays
    return made;
}

QImage painted(const std::shared_ptr<const Figure>& figure, double ratio, CurveLayers* stays) {
    const FigureLayout layout = layOut(*figure, 500);
    QImage image(layout.size * ratio, QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(ratio);
    image.fill(Qt::white);
    QPainter painter(&image);
    if (stays != nullptr) {
        stays->begin(figure);
    }
    paintFigure(painter, *figure, layout, currentTheme(), QLatin1Char('.'), {}, stays);
    return image;
}

int largestDifference(const QImage& one, const QImage& other) {
    int largest = one.size() == other.size() ? 0 : 255;
    for (int y = 0; y < one.height() && largest < 255; ++y) {
        for (int x = 0; x < one.width(); ++x) {
            const QColor a = one.pixelColor(x, y);
            const QColor b = other.pixelColor(x, y);
            largest = std::max({largest, std::abs(a.red() - b.red()), std::abs(a.green() - b.green()),
                                std::abs(a.blue() - b.blue())});
        }
    }
    return largest;
}

using CurveLayersTest = GuiTest;

// Colours are laid over each other in another order of the same sum: two of 255 are their rounding.
TEST_F(CurveLayersTest, whatIsLaidInIsThePictureThatIsDrawn) {
    for (const double ratio : {1.0, 1.5, 2.0}) {
        CurveLayers stays;
        for (const double phase : {0.0, 0.4, 0.8, 1.2}) {
            const auto now = std::make_shared<const Figure>(figure(phase));
            EXPECT_LE(largestDifference(painted(now, ratio, &stays), painted(now, ratio, nullptr)), 2)
                << ratio << " " << phase;
        }
        // A curve that stayed moves, then an axis does.
        const auto other = std::make_shared<const Figure>(figure(1.2, 0.5));
        EXPECT_LE(largestDifference(painted(other, ratio, &stays), painted(other, ratio, nullptr)), 2);
        Figure wide = figure(1.2, 0.5);
        for (Panel& panel : wide.panels) {
            panel.y.max = 3.0;
        }
        const auto wider = std::make_shared<const Figure>(wide);
        EXPECT_LE(largestDifference(painted(wider, ratio, &stays), painted(wider, ratio, nullptr)), 2);
        EXPECT_GT(largestDifference(painted(wider, ratio, nullptr), painted(other, ratio, nullptr)), 50);
    }
}

TEST_F(CurveLayersTest, aRunIsDrawnOnceUntilSomethingOfItIsAnother) {
    CurveLayers stays;
    QImage image(200, 100, QImage::Format_ARGB32_Premultiplied);
    int drawings = 0;
    const QRectF canvas(10.0, 10.0, 150.0, 80.0);
    const auto show = [&](const Figure& shown, const std::vector<double>& axes) {
        stays.begin(std::make_shared<const Figure>(shown));
        const CurveLayers::Run run = stays.runFrom(0, 1);
        QPainter painter(&image);
        const int before = drawings;
        if (run.end > run.first) {
            EXPECT_TRUE(stays.lay(painter, run, canvas, axes,
                                  [&](QPainter&, std::size_t, std::size_t) { ++drawings; }));
        }
        return std::pair(run.end - run.first, drawings - before);
    };
    using Shown = std::pair<std::size_t, int>;
    EXPECT_EQ(show(figure(0.0), {1.0}), Shown(0, 0)); // nothing is known of before
    EXPECT_EQ(show(figure(0.1), {1.0}), Shown(3, 1));
    EXPECT_EQ(show(figure(0.2), {1.0}), Shown(3, 0));
    EXPECT_EQ(show(figure(0.3), {2.0}), Shown(3, 1)); // another axis
    EXPECT_EQ(show(figure(0.3), {2.0}), Shown(3, 0));
    EXPECT_EQ(show(figure(0.3, 0.7), {2.0}), Shown(1, 1)); // the third is another: the run ends there
    EXPECT_EQ(show(figure(0.3, 0.7), {2.0}), Shown(3, 1));
    stays.clear();
    EXPECT_EQ(show(figure(0.3, 0.7), {2.0}), Shown(0, 0)); // other colours
}

// On the screen: a view that followed a curve has the picture of one that sees it for the first time.
TEST_F(CurveLayersTest, aViewThatFollowedShowsWhatAFreshOneShows) {
    FigureView followed;
    FigureView fresh;
    for (FigureView* view : {&followed, &fresh}) {
        view->resize(600, 500);
    }
    for (const double phase : {0.0, 0.5, 1.0}) {
        followed.setFigure(figure(phase));
        (void)followed.grab();
    }
    fresh.setFigure(figure(1.0));
    EXPECT_LE(largestDifference(followed.grab().toImage(), fresh.grab().toImage()), 2);
    followed.setFigure(figure(1.0, 0.2));
    fresh.setFigure(figure(1.0, 0.2));
    EXPECT_LE(largestDifference(followed.grab().toImage(), fresh.grab().toImage()), 2);
    followed.resize(500, 450);
    fresh.resize(500, 450);
    EXPECT_LE(largestDifference(followed.grab().toImage(), fresh.grab().toImage()), 2);
}

} // namespace
} // namespace halbench::widgets
