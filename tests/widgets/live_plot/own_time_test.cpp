#include "tests/widgets/live_plot/live_plot_stack_fixture.h"
#include "widgets/live_plot/axes/time_axis_bar.h"

#include <QtTest>

#include <gtest/gtest.h>

#include <cmath>

// Plots with a time axis of their own in a stack whose other plots share one.

namespace halbench::widgets {
namespace {

using Command = LivePlotStack::Command;
using control::TimeRange;

class OwnTimeTest : public LivePlotStackTest {
protected:
    OwnTimeTest() { QApplication::setActiveWindow(&stack); }
    void press(int plot, Qt::Key code, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        LivePlot* target = plots()[static_cast<std::size_t>(plot)];
        target->setFocus();
        QTest::keyClick(target, code, modifiers);
        frame();
    }
    /// Those that are seen, from the top; the last is the one of the stack.
    std::vector<TimeAxisBar*> bars() const { return fromTopToBottom<TimeAxisBar>(); }
};

TEST_F(OwnTimeTest, aPlotZoomsAndScrollsByItselfAndIsLinkedAgainByTheSameKey) {
    stack.showTimeRange({10.0, 20.0});
    frame();
    press(2, Qt::Key_O);
    ASSERT_TRUE(stack.ownTime(2));
    EXPECT_EQ(stack.timeRange(2), (TimeRange{10.0, 20.0})); // it begins where it stood
    wheel(plots()[2], {plots()[2]->canvasRect().width() / 2, 20}, 3);
    EXPECT_LT(stack.timeRange(2).length_s(), 6.0);
    EXPECT_EQ(stack.timeRange(), (TimeRange{10.0, 20.0}));
    EXPECT_EQ(stack.timeRange(1), stack.timeRange());
    EXPECT_NEAR(plots()[2]->timeAt(0), stack.timeRange(2).begin_s, 0.02); // of the drawing too
    EXPECT_NEAR(plots()[1]->timeAt(0), 10.0, 0.02);
    const TimeRange own = stack.timeRange(2);
    wheel(plots()[0], {100, 20}, -2);
    EXPECT_EQ(stack.timeRange(2), own);
    EXPECT_GT(stack.timeRange().length_s(), 12.0);
    press(2, Qt::Key_O);
    EXPECT_FALSE(stack.ownTime(2));
    EXPECT_EQ(stack.timeRange(2), stack.timeRange());
}

TEST_F(OwnTimeTest, keysActOnTheAxisOfThePlotWithTheFocus) {
    stack.showTimeRange({10.0, 20.0});
    press(3, Qt::Key_O);
    press(3, Qt::Key_Plus);
    EXPECT_NEAR(stack.timeRange(3).length_s(), 10.0 / 1.5, 1e-9);
    press(3, Qt::Key_PageUp);
    EXPECT_NEAR(stack.timeRange(3).begin_s, 15.0 - 5.0 / 1.5 - 0.9 * 10.0 / 1.5, 1e-9);
    press(0, Qt::Key_PageDown);
    EXPECT_NEAR(stack.timeRange().begin_s, 19.0, 1e-9);
    press(3, Qt::Key_Home);
    EXPECT_NEAR(stack.timeRange(3).length_s(), 29.999, 1e-6);
    EXPECT_NEAR(stack.timeRange().begin_s, 19.0, 1e-9);
    press(3, Qt::Key_Backspace); // one history for all
    EXPECT_NEAR(stack.timeRange(3).length_s(), 10.0 / 1.5, 1e-9);
}

TEST_F(OwnTimeTest, itFollowsByItselfAndPauseHoldsAll) {
    press(1, Qt::Key_O); // while all follow
    press(1, Qt::Key_Plus);
    press(0, Qt::Key_PageUp);
    EXPECT_FALSE(stack.isFollowing());
    EXPECT_TRUE(stack.ownTime(1)->isFollowing);
    appendMotor(history, 5.0);
    frame();
    EXPECT_GT(stack.timeRange(1).end_s, 34.9);
    press(0, Qt::Key_Space);
    const TimeRange held = stack.timeRange(1);
    appendMotor(history, 5.0);
    frame();
    EXPECT_EQ(stack.timeRange(1), held);
    EXPECT_TRUE(bars().front()->state().contains("paused")) << bars().front()->state().toStdString();
    press(0, Qt::Key_Space);
    EXPECT_GT(stack.timeRange(1).end_s, 39.9);
    press(1, Qt::Key_PageUp);
    EXPECT_FALSE(stack.ownTime(1)->isFollowing);
    EXPECT_FALSE(stack.action(Command::Follow)->isChecked());
    press(1, Qt::Key_End);
    EXPECT_TRUE(stack.ownTime(1)->isFollowing);
    EXPECT_FALSE(stack.isFollowing());
}

TEST_F(OwnTimeTest, shiftOLinksAllAgain) {
    press(1, Qt::Key_O);
    press(3, Qt::Key_O);
    EXPECT_TRUE(stack.action(Command::OneTimeAxis)->isEnabled());
    press(0, Qt::Key_O, Qt::ShiftModifier);
    EXPECT_FALSE(stack.hasOwnTimes());
    EXPECT_FALSE(stack.action(Command::OneTimeAxis)->isEnabled());
    EXPECT_EQ(bars().size(), 1U);
}

TEST_F(OwnTimeTest, itHasItsOwnLabelsAndAllAxesStayAligned) {
    const std::size_t before = bars().size();
    press(2, Qt::Key_O);
    ASSERT_EQ(bars().size(), before + 1);
    const TimeAxisBar* own = bars()[0];
    EXPECT_TRUE(own->state().startsWith("Own time axis, following")) << own->state().toStdString();
    const int top = own->mapTo(&stack, QPoint()).y();
    EXPECT_GE(top, plots()[2]->mapTo(&stack, QPoint(0, plots()[2]->height())).y());
    EXPECT_LE(top, plots()[3]->mapTo(&stack, QPoint()).y());
    const QRect first = plots().front()->canvasRect();
    for (const LivePlot* plot : plots()) {
        EXPECT_EQ(plot->mapTo(&stack, plot->canvasRect().topLeft()).x(), first.left());
        EXPECT_EQ(plot->canvasRect().width(), first.width());
    }
    for (int plot = 0; plot < 5; ++plot) { // nobody is left on the axis of the stack
        if (plot != 2) {
            press(plot, Qt::Key_O);
        }
    }
    EXPECT_EQ(bars().size(), 5U);
}

TEST_F(OwnTimeTest, theAxisGoesWithItsPlot) {
    stack.showTimeRange({10.0, 20.0});
    press(2, Qt::Key_O);
    press(2, Qt::Key_Plus);
    const TimeRange own = stack.timeRange(2);
    const std::string first = stack.plots()[0].curves.front().signal;
    while (stack.plots()[0].curves.front().signal == first || stack.plots().size() == 5) {
        stack.removeCurve(0, std::string(stack.plots()[0].curves.front().signal));
    }
    frame();
    ASSERT_EQ(stack.plots().size(), 4U);
    EXPECT_FALSE(stack.ownTime(2));
    ASSERT_TRUE(stack.ownTime(1));
    EXPECT_EQ(stack.timeRange(1), own);
    stack.addCurve(1, {"current", "Current", "A", 1.0, 3}); // and stays when its plot changes
    EXPECT_EQ(stack.timeRange(1), own);
}

TEST_F(OwnTimeTest, takingItsOwnAxisLeavesValuesAndHiddenCurvesAsTheyWere) {
    wheel(plots()[0], {100, 20}, 2, Qt::ControlModifier);
    Q_EMIT legends()[0]->toggleRequested(1);
    const ValueRange zoomed = stack.valueRange(0);
    press(0, Qt::Key_O);
    EXPECT_EQ(stack.valueRange(0), zoomed);
    EXPECT_FALSE(plots()[0]->curves()[1]->isVisible());
}

/// The own axis is drawn where the plot's curve is, at every scale: the label's tick stands at the column of
/// that moment.
class OwnTimeAtRatio : public OwnTimeTest, public testing::WithParamInterface<double> {};

TEST_P(OwnTimeAtRatio, ticksStandUnderTheirMoments) {
    stack.setPaused(true);
    press(2, Qt::Key_O);
    stack.setOwnTime(2, OwnTime{4.0, false});
    frame();
    const double ratio = GetParam();
    QImage image(static_cast<int>(std::lround(stack.width() * ratio)),
                 static_cast<int>(std::lround(stack.height() * ratio)), QImage::Format_RGB32);
    image.setDevicePixelRatio(ratio);
    stack.render(&image);
    const TimeAxisBar* bar = bars()[0];
    const QColor panel = loadTheme("light").value().panel;
    const int y = static_cast<int>(std::lround((bar->mapTo(&stack, QPoint()).y() + 3) * ratio));
    const LivePlot* plot = plots()[2];
    const int left = plot->mapTo(&stack, plot->canvasRect().topLeft()).x();
    int ticks = 0;
    for (double second = std::ceil(stack.timeRange(2).begin_s); second < stack.timeRange(2).end_s;
         second += 1.0) {
        const double x = left + plot->canvasMap(QwtPlot::xBottom).transform(second);
        bool isInked = false;
        for (int dx = -2; dx <= 2; ++dx) { // the scale rounds to whole pixels
            const int column = static_cast<int>(std::lround(x * ratio)) + dx;
            isInked = isInked || image.pixelColor(column, y) != panel;
        }
        EXPECT_TRUE(isInked) << second;
        ++ticks;
    }
    EXPECT_GE(ticks, 3);
}

INSTANTIATE_TEST_SUITE_P(Ratios, OwnTimeAtRatio, testing::Values(1.0, 1.5, 2.0));

} // namespace
} // namespace halbench::widgets
