// The mouse on the axes: each is zoomed and moved alone.
#include "tests/widgets/live_plot/live_plot_stack_fixture.h"
#include "widgets/live_plot/axes/time_axis_bar.h"

#include <QWheelEvent>
#include <QtTest/QTest>
#include <qwt_scale_widget.h>

#include <algorithm>

namespace halbench::widgets {
namespace {

class AxisMouseTest : public LivePlotStackTest {
protected:
    void SetUp() override {
        LivePlotStackTest::SetUp();
        std::vector<PlotSpec> specs = motorPlots();
        specs.resize(2);
        PlotCurve speed{"speed", "Speed", "r/min", 30.0 / Pi, 1};
        speed.isRight = true;
        specs[1].curves.push_back(speed);
        specs[1].right = {"speed", "r/min", {}};
        stack.setPlots(specs);
        frame();
        frame();
    }
    QWidget* axis(bool isRight) { return plots()[1]->axisWidget(isRight ? QwtPlot::yRight : QwtPlot::yLeft); }
    TimeAxisBar* timeAxis() {
        for (auto* bar : stack.findChildren<TimeAxisBar*>()) {
            if (bar->isVisible()) {
                return bar;
            }
        }
        return nullptr;
    }
    static void roll(QWidget* widget, QPointF place, int notches) {
        QWheelEvent event(place, widget->mapToGlobal(place.toPoint()), {}, {0, 120 * notches}, Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(widget, &event);
    }
    static void drag(QWidget* widget, QPoint from, QPoint to) {
        QTest::mousePress(widget, Qt::LeftButton, Qt::NoModifier, from);
        QMouseEvent event(QEvent::MouseMove, to, widget->mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                          Qt::NoModifier);
        QApplication::sendEvent(widget, &event);
        QTest::mouseRelease(widget, Qt::LeftButton, Qt::NoModifier, to);
    }
    /// Middle of the canvas in coordinates of the axis.
    QPoint middleOf(QWidget* widget) {
        const QRect canvas = plots()[1]->canvasRect();
        return {widget->width() / 2, widget->mapFrom(plots()[1], canvas.center()).y()};
    }
};

// Two notches magnify by 1.25 squared, and the value under the mouse stays; one row of pixels of the canvas
// is the tolerance of the place.
TEST_F(AxisMouseTest, theWheelZoomsThatAxisAloneAboutTheMouse) {
    for (const bool isRight : {false, true}) {
        stack.rescale(false);
        frame();
        const ValueRange before = stack.valueRange(1, isRight);
        const ValueRange other = stack.valueRange(1, !isRight);
        const ValueRange above = stack.valueRange(0);
        const control::TimeRange time = stack.timeRange();
        roll(axis(isRight), middleOf(axis(isRight)), 2);
        frame();
        const ValueRange after = stack.valueRange(1, isRight);
        const double row = before.length() / plots()[1]->canvasRect().height();
        EXPECT_NEAR(after.length(), before.length() / (1.25 * 1.25), 1e-9 * before.length());
        EXPECT_NEAR(0.5 * (after.low + after.high), 0.5 * (before.low + before.high), row);
        EXPECT_TRUE(stack.heldRange(1, isRight));
        EXPECT_FALSE(stack.heldRange(1, !isRight));
        EXPECT_EQ(stack.valueRange(1, !isRight), other);
        EXPECT_EQ(stack.valueRange(0), above);
        EXPECT_EQ(stack.timeRange().length_s(), time.length_s());
    }
}

TEST_F(AxisMouseTest, aDragMovesTheAxisWithTheMouseAndBackspaceGoesBack) {
    const ValueRange before = stack.valueRange(1);
    const QPoint middle = middleOf(axis(false));
    drag(axis(false), middle, middle + QPoint(0, 20));
    frame();
    const ValueRange after = stack.valueRange(1);
    const double row = before.length() / plots()[1]->canvasRect().height();
    // Down by twenty pixels: larger values come into view.
    EXPECT_NEAR(after.low - before.low, 20.0 * row, row);
    EXPECT_NEAR(after.length(), before.length(), 1e-9 * before.length());
    stack.action(LivePlotStack::Command::ZoomBack)->trigger();
    frame();
    EXPECT_FALSE(stack.heldRange(1));
}

TEST_F(AxisMouseTest, aClickHoldsNothing) {
    QTest::mouseClick(axis(false), Qt::LeftButton, Qt::NoModifier, middleOf(axis(false)));
    EXPECT_FALSE(stack.heldRange(1));
}

TEST_F(AxisMouseTest, aDoubleClickLetsThatAxisFollowItsDataAgain) {
    const ValueRange fitted = stack.valueRange(1);
    roll(axis(false), middleOf(axis(false)), -6);
    roll(axis(true), middleOf(axis(true)), -6);
    frame();
    const std::optional<ValueRange> right = stack.heldRange(1, true);
    ASSERT_TRUE(right && stack.heldRange(1));
    QTest::mouseDClick(axis(false), Qt::LeftButton, Qt::NoModifier, middleOf(axis(false)));
    frame();
    EXPECT_FALSE(stack.heldRange(1));
    EXPECT_EQ(stack.valueRange(1), fitted);
    EXPECT_EQ(stack.heldRange(1, true), right) << "the other one is held on";
}

TEST_F(AxisMouseTest, onTheTimeAxisTheWheelZoomsAndADragScrolls) {
    stack.showTimeRange({2.0, 6.0});
    frame();
    const ValueRange values = stack.valueRange(1);
    const QRect canvas = plots()[1]->canvasRect();
    const int left = timeAxis()->mapFromGlobal(plots()[1]->mapToGlobal(canvas.topLeft())).x();
    roll(timeAxis(), QPointF(left + canvas.width() / 2.0, 5.0), 1);
    frame();
    const control::TimeRange zoomed = stack.timeRange();
    const double column_s = 4.0 / canvas.width();
    EXPECT_NEAR(zoomed.length_s(), 4.0 / 1.25, 2.0 * column_s);
    EXPECT_NEAR(0.5 * (zoomed.begin_s + zoomed.end_s), 4.0, 2.0 * column_s);
    drag(timeAxis(), {left + 100, 5}, {left + 50, 5}); // to the left: later
    frame();
    EXPECT_NEAR(stack.timeRange().begin_s - zoomed.begin_s, 50.0 * zoomed.length_s() / canvas.width(),
                2.0 * column_s);
    EXPECT_EQ(stack.valueRange(1), values);
    QTest::mouseDClick(timeAxis(), Qt::LeftButton, Qt::NoModifier, {left + 100, 5});
    frame();
    EXPECT_GT(stack.timeRange().length_s(), 6.0) << "all of the history";
}

} // namespace
} // namespace halbench::widgets
