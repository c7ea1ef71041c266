#include "tests/widgets/live_plot/live_plot_stack_fixture.h"
#include "widgets/live_plot/axes/time_axis_bar.h"
#include "widgets/live_plot/cursor_bar.h"

#include <QAction>
#include <QApplication>
#include <QDropEvent>
#include <QMimeData>
#include <QSplitter>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::widgets {
namespace {

using control::TimeRange;

TEST_F(LivePlotStackTest, followsTheNewestSampleAndPausesWithoutLosingData) {
    EXPECT_NEAR(stack.timeRange().end_s, 29.999, 0.02);
    trigger(LivePlotStack::Command::Pause);
    EXPECT_TRUE(stack.isPaused());
    const TimeRange paused = stack.timeRange();
    appendMotor(history, 5.0);
    frame();
    EXPECT_EQ(stack.timeRange(), paused);
    EXPECT_TRUE(stack.findChild<TimeAxisBar*>()->state().contains("Paused"));
    trigger(LivePlotStack::Command::Pause);
    EXPECT_TRUE(stack.isFollowing());
    EXPECT_GT(stack.timeRange().end_s, 34.0);
}

TEST_F(LivePlotStackTest, plotsAreEquallyHighWhateverWasThereBefore) {
    auto* rows = stack.findChild<QSplitter*>()->findChild<QSplitter*>(); // of the one column
    rows->setSizes({600, 60, 60, 60, 60});
    std::vector<PlotSpec> fewer = stack.plots();
    fewer.resize(3);
    stack.setPlots(fewer);
    QApplication::processEvents();
    int lowest = stack.height();
    int highest = 0;
    for (const LivePlot* plot : plots()) {
        lowest = std::min(lowest, plot->height());
        highest = std::max(highest, plot->height());
    }
    EXPECT_LE(highest - lowest, 2); // rounding
}

TEST_F(LivePlotStackTest, wheelZoomsTimeAtThePointerOfAllPlots) {
    stack.showTimeRange({10.0, 20.0});
    frame();
    LivePlot* plot = plots()[1];
    const QPoint place(plot->canvasRect().width() / 4, 20);
    const double under_s = plot->timeAt(place.x());
    wheel(plot, place, 3);
    EXPECT_LT(stack.timeRange().length_s(), 6.0);
    EXPECT_NEAR(plot->timeAt(place.x()), under_s, 1e-6);
    EXPECT_NEAR(plots()[4]->timeAt(place.x()), under_s, 1e-6);
    trigger(LivePlotStack::Command::ZoomBack); // the turns of the wheel are one step
    EXPECT_NEAR(stack.timeRange().length_s(), 10.0, 1e-9);
}

TEST_F(LivePlotStackTest, controlAndWheelZoomTheValuesOfOnePlot) {
    const double before = stack.valueRange(1).length();
    const double other = stack.valueRange(0).length();
    wheel(plots()[1], {100, 20}, 2, Qt::ControlModifier);
    EXPECT_LT(stack.valueRange(1).length(), 0.8 * before);
    EXPECT_EQ(stack.valueRange(0).length(), other);
    trigger(LivePlotStack::Command::ZoomBack);
    EXPECT_DOUBLE_EQ(stack.valueRange(1).length(), before);
}

TEST_F(LivePlotStackTest, leftDragZoomsIntoTheBoxAndFGoesBackToTheData) {
    LivePlot* plot = plots()[2];
    const double left_s = plot->timeAt(100.0);
    const double right_s = plot->timeAt(300.0);
    const double all = stack.valueRange(2).length();
    drag(plot, {100, 20}, {300, 80}, Qt::LeftButton);
    EXPECT_FALSE(stack.isFollowing());
    EXPECT_NEAR(stack.timeRange().begin_s, left_s, 1e-6);
    EXPECT_NEAR(stack.timeRange().end_s, right_s, 1e-6);
    EXPECT_LT(stack.valueRange(2).length(), 0.7 * all);
    trigger(LivePlotStack::Command::Fit);
    EXPECT_NEAR(stack.timeRange().begin_s, 0.0, 1e-6);
    EXPECT_NEAR(stack.timeRange().end_s, 29.999, 1e-6);
}

TEST_F(LivePlotStackTest, aClickIsNotABox) {
    const TimeRange before = stack.timeRange();
    drag(plots()[0], {100, 20}, {102, 21}, Qt::LeftButton);
    EXPECT_DOUBLE_EQ(stack.timeRange().begin_s, before.begin_s);
    EXPECT_DOUBLE_EQ(stack.timeRange().end_s, before.end_s);
    EXPECT_TRUE(stack.isFollowing());
}

TEST_F(LivePlotStackTest, controlDragAndMiddleDragPan) {
    const double begin_s = stack.timeRange().begin_s;
    const double width = plots()[0]->canvasRect().width() - 1;
    drag(plots()[0], {100, 20}, {200, 20}, Qt::LeftButton, Qt::ControlModifier);
    EXPECT_FALSE(stack.isFollowing());
    EXPECT_NEAR(stack.timeRange().begin_s, begin_s - 100.0 * 10.0 / width, 1e-6);
    drag(plots()[0], {200, 20}, {100, 20}, Qt::MiddleButton);
    EXPECT_NEAR(stack.timeRange().begin_s, begin_s, 1e-6);
    trigger(LivePlotStack::Command::Follow);
    EXPECT_TRUE(stack.isFollowing());
}

TEST_F(LivePlotStackTest, cursorsMeasureDifferencesOfEveryCurve) {
    trigger(LivePlotStack::Command::Cursors);
    stack.setCursor(0, 25.2);
    stack.setCursor(1, 26.2);
    frame();
    EXPECT_TRUE(stack.findChild<CursorBar*>()->distanceText().contains("1.0000 s"));
    LegendTableModel& table = legends()[3]->table(); // the current changes from -0.31 to 0.31 A
    EXPECT_EQ(table.data(table.index(0, LegendTableModel::AtA), Qt::DisplayRole).toString(), "-0.310");
    EXPECT_EQ(table.data(table.index(0, LegendTableModel::Difference), Qt::DisplayRole).toString(), "0.620");
}

TEST_F(LivePlotStackTest, arrowsMoveTheActiveCursorShiftCoarsely) {
    trigger(LivePlotStack::Command::CursorB);
    const CursorPair before = stack.cursors();
    EXPECT_TRUE(before.isVisible);
    key(Qt::Key_Right);
    const double fine_s = stack.cursors().b_s - before.b_s;
    EXPECT_NEAR(fine_s, 10.0 / (plots()[0]->canvasRect().width() - 1), 1e-6);
    key(Qt::Key_Left, Qt::ShiftModifier);
    EXPECT_NEAR(stack.cursors().b_s - before.b_s, -49.0 * fine_s, 1e-6);
    EXPECT_EQ(stack.cursors().a_s, before.a_s);
}

TEST_F(LivePlotStackTest, cursorsAreDraggedByTheirLine) {
    stack.setCursorsVisible(true);
    stack.setCursor(0, stack.timeRange().begin_s + 2.0);
    frame();
    LivePlot* plot = plots()[4];
    const int x =
        static_cast<int>(std::lround(plot->canvasMap(QwtPlot::xBottom).transform(stack.cursors().a_s)));
    drag(plot, {x + 2, 30}, {x + 100, 30}, Qt::LeftButton);
    EXPECT_NEAR(stack.cursors().a_s, plot->timeAt(x + 100), 1e-6);
    EXPECT_TRUE(stack.isFollowing()); // it was no box
}

TEST_F(LivePlotStackTest, legendShowsLiveValuesInTheUnitOfTheCurve) {
    LegendTableModel& table = legends()[1]->table();
    const double angle_deg = radiansToDegrees(history.latest("angle")->value);
    EXPECT_EQ(table.data(table.index(0, LegendTableModel::Value), Qt::DisplayRole).toString(),
              QString::number(angle_deg, 'f', 2));
    EXPECT_EQ(table.data(table.index(0, LegendTableModel::Unit), Qt::DisplayRole).toString(), "°");
    EXPECT_TRUE(table.data(table.index(0, 0), Qt::AccessibleTextRole).toString().contains("Angle"));
}

TEST_F(LivePlotStackTest, droppedSignalsNameThePlot) {
    int droppedOn = -5;
    QStringList dropped;
    QObject::connect(&stack, &LivePlotStack::signalsDropped, &stack, [&](int plot, const QStringList& names) {
        droppedOn = plot;
        dropped = names;
    });
    QMimeData data;
    data.setData(SignalsMimeType, "hall.a\nspeed\n");
    QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(plots()[2], &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent drop(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(plots()[2], &drop);
    EXPECT_EQ(droppedOn, 2);
    EXPECT_EQ(dropped, QStringList({"hall.a", "speed"}));
}

TEST_F(LivePlotStackTest, curvesAreAddedOnceAndRemovedByTheLegend) {
    stack.addCurve(1, {"speed", "Speed", "r/min", 1.0, 1});
    stack.addCurve(1, {"speed", "Speed", "r/min", 1.0, 1});
    ASSERT_EQ(stack.plots()[1].curves.size(), 2U);
    stack.addCurve(99, {"current", "Current", "A", 1.0, 3});
    frame();
    ASSERT_EQ(stack.plots().size(), 6U);
    EXPECT_EQ(stack.plots()[5].quantity, "Current");
    Q_EMIT legends()[5]->removeRequested(0);
    frame();
    EXPECT_EQ(stack.plots().size(), 5U);
    EXPECT_EQ(plots().size(), 5U);
}

TEST_F(LivePlotStackTest, addingToOnePlotLeavesTheOthersAsTheyWere) {
    wheel(plots()[1], {100, 20}, 2, Qt::ControlModifier);
    Q_EMIT legends()[0]->toggleRequested(1);
    const ValueRange zoomed = stack.valueRange(1);
    stack.addCurve(2, {"current", "Current", "A", 1.0, 3});
    frame();
    EXPECT_EQ(stack.valueRange(1), zoomed);
    EXPECT_FALSE(plots()[0]->curves()[1]->isVisible());
}

TEST_F(LivePlotStackTest, noTurningOfTheWheelMakesAnAxisThatCannotBeShown) {
    for (int i = 0; i < 40; ++i) {
        wheel(plots()[1], {100, 20}, 10, Qt::ControlModifier);
    }
    EXPECT_GT(stack.valueRange(1).length(), 0.0);
    for (int i = 0; i < 120; ++i) {
        wheel(plots()[1], {100, 20}, -10, Qt::ControlModifier);
    }
    EXPECT_TRUE(std::isfinite(stack.valueRange(1).length()));
}

TEST_F(LivePlotStackTest, limitBandsAreSeenWhereTheAxisReachesThem) {
    std::vector<PlotSpec> specs = motorPlots();
    specs[4].fixedRange = ValueRange{50.0, 80.0};
    stack.setPlots(specs);
    frame();
    LivePlot* plot = plots()[4];
    const auto colourAt = [&](double value) {
        const QImage image = plot->canvas()->grab().toImage();
        return image.pixelColor(3, static_cast<int>(plot->canvasMap(QwtPlot::yLeft).transform(value)));
    };
    const QColor plain = loadTheme("light").value().plotBackground;
    EXPECT_EQ(colourAt(52.5), plain);
    EXPECT_NE(colourAt(67.5), plain);
    EXPECT_NE(colourAt(73.5), plain);
    EXPECT_NE(colourAt(73.5), colourAt(67.5));
}

TEST_F(LivePlotStackTest, anEmptyStackSaysWhatItIsFor) {
    stack.setPlots({});
    frame();
    ASSERT_EQ(stack.plots().size(), 1U);
    EXPECT_EQ(plots().front()->accessibleName(), "Empty plot");
    stack.addCurve(-1, {"speed", "Speed", "r/min", 1.0, 1});
    EXPECT_EQ(stack.plots().size(), 1U); // the empty plot was for this
    stack.setHistory(nullptr);
    frame();
}

TEST_F(LivePlotStackTest, drawsOnlyWhenSomethingChanged) {
    int frames = 0;
    QObject::connect(&stack, &LivePlotStack::frameStarting, &stack, [&] { ++frames; });
    const double before = stack.timeRange().end_s;
    stack.refresh();
    EXPECT_EQ(frames, 1);
    EXPECT_DOUBLE_EQ(stack.timeRange().end_s, before);
}

TEST_F(LivePlotStackTest, markersStandWhereTheyWereDropped) {
    trigger(LivePlotStack::Command::Marker);
    ASSERT_EQ(stack.markers().size(), 1U);
    EXPECT_NEAR(stack.markers()[0].time_s, 29.999, 1e-9);
    EXPECT_EQ(stack.markers()[0].text, "1");
}

TEST_F(LivePlotStackTest, everyCommandSaysItsShortcut) {
    for (int i = 0; i <= static_cast<int>(LivePlotStack::Command::AddSignals); ++i) {
        const QAction* action = stack.action(static_cast<LivePlotStack::Command>(i));
        EXPECT_FALSE(action->text().isEmpty());
        EXPECT_TRUE(action->toolTip().contains(action->shortcut().toString(QKeySequence::NativeText)));
    }
    for (const QWidget* widget : stack.findChildren<QWidget*>()) {
        if (widget->focusPolicy() != Qt::NoFocus && widget->isVisible()) {
            EXPECT_FALSE(widget->accessibleName().isEmpty()) << widget->metaObject()->className();
        }
    }
}

} // namespace
} // namespace halbench::widgets
