#include "tests/widgets/live_plot/live_plot_stack_fixture.h"
#include "widgets/language/display_units.h"
#include "widgets/live_plot/hover_readout.h"

#include <cmath>

namespace halbench::widgets {
namespace {

TEST_F(LivePlotStackTest, thePointerReadsTheCurvesOfItsPlot) {
    LivePlot* plot = plots().at(1); // the angle
    const QPoint place(plot->canvas()->width() / 3, 20);
    mouse(plot, QEvent::MouseMove, place, Qt::NoButton);
    frame();
    ASSERT_TRUE(plot->hover());
    ASSERT_EQ(plot->hover()->lines.size(), 2U);
    // The rows are a millisecond apart and the angle is the sum of two sines.
    const double t = 0.001 * std::round(1000.0 * plot->timeAt(place.x()));
    const double angle_rad = 2.5 * std::sin(2.0 * t) + 0.4 * std::sin(9.0 * t);
    EXPECT_EQ(plot->hover()->lines[1].text,
              QStringLiteral("Angle %1 \u00b0").arg(fixedText(angle_rad * 180.0 / Pi, 2)));
    EXPECT_EQ(plot->hover()->lines[1].colour, plot->curves().front()->colour());
    EXPECT_TRUE(plot->hover()->lines[0].text.endsWith(QStringLiteral(" s")));
    EXPECT_FALSE(plots().at(2)->hover());
}

TEST_F(LivePlotStackTest, nothingIsReadWhileDraggedNorAfterThePointerLeft) {
    LivePlot* plot = plots().at(1);
    mouse(plot, QEvent::MouseMove, {200, 20}, Qt::NoButton);
    frame();
    ASSERT_TRUE(plot->hover());
    mouse(plot, QEvent::MouseButtonPress, {200, 20}, Qt::LeftButton);
    frame();
    EXPECT_FALSE(plot->hover());
    mouse(plot, QEvent::MouseButtonRelease, {200, 20}, Qt::LeftButton);
    mouse(plot, QEvent::MouseMove, {210, 20}, Qt::NoButton);
    frame();
    EXPECT_TRUE(plot->hover());
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(plot->canvas(), &leave);
    frame();
    EXPECT_FALSE(plot->hover());
}

TEST_F(LivePlotStackTest, atRestTheAxisOfASensorSpansTwentyStepsOfItsConverter) {
    constexpr double Step_rad = 0.0025;
    control::SampleHistory resting(std::size_t{1} << 22U);
    const auto layout = control::layoutOf({"position"}, 0.001);
    resting.append(control::blockOf(
        layout, 0, 1000, [](std::size_t row, std::size_t) { return row % 3 == 0 ? Step_rad : 0.0; }));
    LivePlot plot;
    PlotSpec spec{"angle", "\u00b0", {{"position", "Angle", "\u00b0", 180.0 / Pi, 2}}, {}, {}};
    const auto shownLength = [&] {
        plot.setSpec(spec, &resting);
        plot.showFrame({0.0, 1.0}, 0.1, {0.0, 1.0});
        return plot.shownRange().length();
    };
    EXPECT_LT(shownLength(), 3.0 * Step_rad * 180.0 / Pi);
    spec.curves.front().isSensor = true;
    // Whole steps of 1, 2 or 5 around it: at most two and a half times as long.
    EXPECT_GE(shownLength(), 20.0 * Step_rad * 180.0 / Pi);
    EXPECT_LE(shownLength(), 50.0 * Step_rad * 180.0 / Pi);
}

} // namespace
} // namespace halbench::widgets
