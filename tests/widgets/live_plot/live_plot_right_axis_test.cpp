#include "tests/widgets/live_plot/live_plot_stack_fixture.h"

#include <qwt_scale_map.h>
#include <qwt_scale_widget.h>

#include <cmath>

// Plots with an axis at either side.

namespace halbench::widgets {
namespace {

class RightAxisTest : public LivePlotStackTest {
protected:
    /// Speed, alone in the third plot, to the angle in the second one.
    void joinSpeedWithAngle() {
        ASSERT_TRUE(stack.moveCurve(2, "speed", 1));
        frame();
        frame();
    }
    const PlotSpec& spec(std::size_t plot) const { return stack.plots()[plot]; }
    static double atRight(const LivePlot& plot, double value) {
        return plot.canvasMap(QwtPlot::yRight).transform(value);
    }
};

TEST_F(RightAxisTest, aCurveOfAnotherUnitJoinsAPlotOnItsFreeRightAxis) {
    joinSpeedWithAngle();
    ASSERT_EQ(stack.plots().size(), 4U); // its own plot had nothing else
    EXPECT_EQ(spec(1).unit, QString::fromUtf8("°"));
    EXPECT_EQ(spec(1).right.unit, "r/min");
    EXPECT_EQ(spec(1).right.quantity, "speed");
    ASSERT_EQ(spec(1).curves.size(), 2U);
    EXPECT_TRUE(spec(1).curves[1].isRight);
    EXPECT_FALSE(stack.moveCurve(2, "current", 1)) << "the right axis has one unit, and so has the left one";
    EXPECT_FALSE(stack.moveCurve(1, "speed", 7));
    EXPECT_FALSE(stack.moveCurve(1, "no such", 0));
}

TEST_F(RightAxisTest, canvasesAlignOnBothSidesAndStayWhileLabelsGrow) {
    joinSpeedWithAngle();
    const auto all = plots();
    const QRect first = all.front()->canvasRect();
    for (const LivePlot* plot : all) {
        EXPECT_EQ(plot->mapTo(&stack, plot->canvasRect().topLeft()).x(), first.left());
        EXPECT_EQ(plot->canvasRect().width(), first.width());
        EXPECT_EQ(plot->axisWidget(QwtPlot::yRight)->width(),
                  all.front()->axisWidget(QwtPlot::yRight)->width());
    }
    // Only the plot with a curve there has ticks and a title at the right.
    EXPECT_TRUE(all[0]->axisScaleDiv(QwtPlot::yRight).ticks(QwtScaleDiv::MajorTick).isEmpty());
    EXPECT_FALSE(all[1]->axisScaleDiv(QwtPlot::yRight).ticks(QwtScaleDiv::MajorTick).isEmpty());
    EXPECT_TRUE(all[1]->axisTitle(QwtPlot::yRight).text().contains("[r/min]"));
    stack.fitAll();
    frame();
    appendMotor(history, 5.0);
    frame();
    EXPECT_EQ(plots().front()->canvasRect(), first);
}

TEST_F(RightAxisTest, theLastCurveThatLeavesTheRightTakesTheAxisAlong) {
    const int before = plots().front()->canvasRect().width();
    ASSERT_TRUE(stack.moveToAxis(0, "hall.b", true));
    frame();
    EXPECT_LT(plots().front()->canvasRect().width(), before);
    EXPECT_FALSE(stack.moveToAxis(0, "hall.a", true)) << "one stays at the left";
    EXPECT_FALSE(stack.moveToAxis(0, "hall.b", true)) << "it is there";
    ASSERT_TRUE(stack.moveToAxis(0, "hall.b", false));
    frame();
    frame();
    EXPECT_EQ(plots().front()->canvasRect().width(), before);
    EXPECT_EQ(spec(0).right, PlotAxis());
}

TEST_F(RightAxisTest, whatIsLeftOfAPlotIsOnItsLeftAxis) {
    joinSpeedWithAngle();
    stack.removeCurve(1, "angle");
    frame();
    ASSERT_EQ(spec(1).curves.size(), 1U);
    EXPECT_FALSE(spec(1).curves[0].isRight);
    EXPECT_EQ(spec(1).unit, "r/min");
    EXPECT_FALSE(hasRightAxis(spec(1)));
}

/// The picture of a curve on the right axis is the one that it has alone on a left axis of the same range.
TEST_F(RightAxisTest, aCurveIsDrawnByItsOwnAxis) {
    stack.setPaused(true);
    joinSpeedWithAngle();
    LivePlot* plot = plots()[1];
    EXPECT_NE(stack.valueRange(1, false).high, stack.valueRange(1, true).high);
    const control::Extremes extremes = history.extremes("speed", stack.timeRange());
    const double highest = atRight(*plot, 30.0 / Pi * extremes.max);
    const double lowest = atRight(*plot, 30.0 / Pi * extremes.min);
    plot->curves()[0]->setVisible(false);
    plot->replot();
    QApplication::processEvents();
    const QImage seen = plot->canvas()->grab().toImage();
    const QColor ink = plot->curves()[1]->colour();
    int top = seen.height();
    int bottom = 0;
    for (int y = 0; y < seen.height(); ++y) {
        for (int x = 1; x < seen.width() - 1; ++x) {
            const QColor pixel = seen.pixelColor(x, y);
            const int away = std::abs(pixel.red() - ink.red()) + std::abs(pixel.green() - ink.green()) +
                             std::abs(pixel.blue() - ink.blue());
            if (away < 30) {
                top = std::min(top, y);
                bottom = std::max(bottom, y);
            }
        }
    }
    EXPECT_NEAR(top, highest, 2.0); // half a line's width and its soft edge
    EXPECT_NEAR(bottom, lowest, 2.0);
}

TEST_F(RightAxisTest, zoomingValuesKeepsBothAxesBesideEachOther) {
    stack.setPaused(true);
    joinSpeedWithAngle();
    LivePlot* plot = plots()[1];
    const ValueRange left = stack.valueRange(1, false);
    const ValueRange right = stack.valueRange(1, true);
    wheel(plot, QPoint(100, plot->canvas()->height() / 4), 3, Qt::ControlModifier);
    const ValueRange leftNow = stack.valueRange(1, false);
    const ValueRange rightNow = stack.valueRange(1, true);
    EXPECT_LT(leftNow.length(), left.length());
    // What stood beside each other still does.
    EXPECT_NEAR((leftNow.low - left.low) / left.length(), (rightNow.low - right.low) / right.length(), 1e-9);
    EXPECT_NEAR(leftNow.length() / left.length(), rightNow.length() / right.length(), 1e-9);
    EXPECT_TRUE(stack.heldRange(1, true));
    trigger(LivePlotStack::Command::ZoomBack);
    EXPECT_FALSE(stack.heldRange(1, true));
    EXPECT_FALSE(stack.heldRange(1, false));
}

TEST_F(RightAxisTest, aLevelOfARightCurveStandsWhereThatAxisHasItAndIsDraggedThere) {
    stack.setPaused(true);
    joinSpeedWithAngle();
    LivePlot* plot = plots()[1];
    stack.setLevel(PlotLevel{"speed", 2.0, 0.0}); // rad/s
    frame();
    std::optional<double> moved;
    QObject::connect(&stack, &LivePlotStack::levelMoved, [&](double level) { moved = level; });
    const int from = static_cast<int>(std::lround(atRight(*plot, 2.0 * 30.0 / Pi)));
    drag(plot, {200, from}, {200, from - 20}, Qt::LeftButton);
    ASSERT_TRUE(moved);
    EXPECT_NEAR(atRight(*plot, *moved * 30.0 / Pi), from - 20.0, 1e-6);
}

TEST_F(RightAxisTest, aLegendMovesItsChosenCurveByKeysAndSaysWhereItIs) {
    const auto press = [&](LiveLegend* legend, int code, Qt::KeyboardModifiers modifiers) {
        QKeyEvent event(QEvent::KeyPress, code, modifiers);
        QApplication::sendEvent(legend, &event);
        frame();
    };
    int changes = 0;
    QObject::connect(&stack, &LivePlotStack::plotsChanged, [&] { ++changes; });
    LiveLegend* third = legends()[2];
    third->setCurrentIndex(third->model()->index(0, 0));
    press(third, Qt::Key_Up, Qt::ControlModifier);
    ASSERT_EQ(stack.plots().size(), 4U);
    LiveLegend* second = legends()[1];
    EXPECT_EQ(second->currentIndex().row(), 1) << "keys go on with the same curve";
    EXPECT_EQ(second->model()->index(1, 0).data().toString(), "Speed (right)");
    EXPECT_TRUE(
        second->model()->index(1, 0).data(Qt::AccessibleTextRole).toString().startsWith("Speed (right)"));
    EXPECT_TRUE(plots()[1]->accessibleName().contains("speed"));
    LiveLegend* top = legends()[0];
    top->setCurrentIndex(top->model()->index(1, 0));
    press(top, Qt::Key_R, Qt::NoModifier);
    EXPECT_TRUE(spec(0).curves[1].isRight);
    press(legends()[0], Qt::Key_R, Qt::NoModifier);
    EXPECT_FALSE(spec(0).curves[1].isRight);
    EXPECT_EQ(changes, 3);
}

} // namespace
} // namespace halbench::widgets
