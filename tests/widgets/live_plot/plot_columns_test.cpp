// Plots beside each other.
#include "tests/widgets/live_plot/live_plot_stack_fixture.h"
#include "widgets/live_plot/axes/time_axis_bar.h"
#include "widgets/live_plot/live_plot_spec.h"

#include <QDropEvent>
#include <QMimeData>

namespace halbench::widgets {
namespace {

class PlotColumnsTest : public LivePlotStackTest {
protected:
    void press(QWidget* widget, int code, Qt::KeyboardModifiers modifiers) {
        widget->setFocus();
        QKeyEvent event(QEvent::KeyPress, code, modifiers);
        QApplication::sendEvent(widget, &event);
        frame();
    }
    /// On the first curve of that plot's legend.
    void pressIn(LiveLegend* legend, int code, Qt::KeyboardModifiers modifiers) {
        legend->setFocus();
        legend->setCurrentIndex(legend->model()->index(0, 0));
        press(legend, code, modifiers);
    }
    const PlotSpec& spec(std::size_t plot) const { return stack.plots()[plot]; }
    std::vector<int> columns() const {
        std::vector<int> list;
        for (const PlotSpec& plot : stack.plots()) {
            list.push_back(plot.column);
        }
        return list;
    }
    /// Of the visible ones: what is shown of the plot of that quantity.
    LivePlot* shown(const QString& quantity) const {
        for (LivePlot* plot : plots()) {
            if (plot->spec().quantity == quantity) {
                return plot;
            }
        }
        return nullptr;
    }
    LiveLegend* legendOf(LivePlot* plot) const { return plot->parentWidget()->findChild<LiveLegend*>(); }
    int left(const LivePlot* plot) const { return plot->mapTo(&stack, plot->canvasRect().topLeft()).x(); }
    std::vector<TimeAxisBar*> sharedAxes() const {
        std::vector<TimeAxisBar*> axes;
        for (TimeAxisBar* bar : stack.findChildren<TimeAxisBar*>()) {
            if (bar->isVisible()) {
                axes.push_back(bar);
            }
        }
        return axes;
    }
};

TEST_F(PlotColumnsTest, aPlotGoesBesideTheOthersAndBackByKey) {
    const std::vector<PlotSpec> before = stack.plots();
    const int whole = plots().front()->canvasRect().width();
    LivePlot* moved = plots()[1];
    moved->setFocus();
    trigger(LivePlotStack::Command::PlotRight);
    EXPECT_EQ(columns(), (std::vector<int>{0, 0, 0, 0, 1}));
    EXPECT_EQ(spec(4).quantity, before[1].quantity);
    EXPECT_TRUE(moved->hasFocus()) << "keys go on with it";
    EXPECT_LT(moved->canvasRect().width(), whole);
    EXPECT_GT(left(moved), left(shown(before[0].quantity)) + shown(before[0].quantity)->canvasRect().width());
    EXPECT_GT(moved->height(), 3 * shown(before[0].quantity)->height()) << "alone in its column";
    trigger(LivePlotStack::Command::PlotRight); // nothing is beyond it
    EXPECT_EQ(stack.columnCount(), 2);
    trigger(LivePlotStack::Command::PlotLeft); // its column goes
    EXPECT_EQ(columns(), (std::vector<int>{0, 0, 0, 0, 0}));
    EXPECT_EQ(spec(0).quantity, before[1].quantity) << "where it stood beside";
    EXPECT_EQ(sharedAxes().size(), 1U);
    trigger(LivePlotStack::Command::PlotLeft);
    EXPECT_EQ(columns(), (std::vector<int>{0, 1, 1, 1, 1})) << "a column before the first";
}

TEST_F(PlotColumnsTest, axesOfAColumnAlignAndAllShowTheSameTime) {
    ASSERT_TRUE(stack.movePlot(1, 1));
    ASSERT_TRUE(stack.movePlot(3, 1));
    frame();
    frame();
    ASSERT_EQ(columns(), (std::vector<int>{0, 0, 0, 1, 1}));
    for (const auto& [plot, other] : {std::pair(0U, 2U), std::pair(3U, 4U)}) {
        const LivePlot* upper = shown(spec(plot).quantity);
        const LivePlot* lower = shown(spec(other).quantity);
        EXPECT_EQ(left(upper), left(lower));
        EXPECT_EQ(upper->canvasRect().width(), lower->canvasRect().width());
    }
    EXPECT_EQ(sharedAxes().size(), 2U);
    // While following, each column moves by its own whole pixels: never further apart than one of them.
    const LivePlot* first = shown(spec(0).quantity);
    const LivePlot* second = shown(spec(4).quantity);
    const double pixel_s = stack.timeRange().length_s() / (second->canvasRect().width() - 1);
    EXPECT_NEAR(first->axisInterval(QwtPlot::xBottom).maxValue(),
                second->axisInterval(QwtPlot::xBottom).maxValue(), 2.0 * pixel_s);
    stack.showTimeRange({3.0, 7.0});
    frame();
    EXPECT_EQ(first->axisInterval(QwtPlot::xBottom), second->axisInterval(QwtPlot::xBottom));
    wheel(shown(spec(4).quantity), {50, 30}, 3);
    EXPECT_EQ(first->axisInterval(QwtPlot::xBottom), second->axisInterval(QwtPlot::xBottom));
    EXPECT_LT(first->axisInterval(QwtPlot::xBottom).width(), 3.0);
    const auto says = [](const TimeAxisBar* bar) { return !bar->state().isEmpty(); };
    const auto axes = sharedAxes();
    EXPECT_EQ(std::count_if(axes.begin(), axes.end(), says), 1) << "once is enough";
}

TEST_F(PlotColumnsTest, aLegendThatWouldTakeThePlotsWidthStandsBelowIt) {
    ASSERT_TRUE(stack.movePlot(1, 1));
    stack.resize(700, 900); // what a window of 1440 leaves for two columns
    for (int i = 0; i < 3; ++i) {
        frame();
    }
    const LivePlot* moved = shown(spec(4).quantity);
    EXPECT_GT(moved->canvasRect().width(), 0.6 * moved->width()) << "the data have the room";
    EXPECT_GE(legendOf(shown(spec(4).quantity))->y(), moved->height());
    const int name_px = legendOf(shown(spec(4).quantity))->columnWidth(LegendTableModel::Name);
    EXPECT_GT(name_px, 100) << "names are whole";
    stack.setCursorsVisible(true);
    stack.resize(560, 900); // with the cursors' columns there is no room for a name
    for (int i = 0; i < 3; ++i) {
        frame();
    }
    EXPECT_GT(moved->canvasRect().width(), 0.6 * moved->width());
    const LiveLegend* narrow = legendOf(shown(spec(4).quantity));
    EXPECT_TRUE(narrow->isColumnHidden(LegendTableModel::Value)) << "the values at the cursors are asked for";
    EXPECT_GT(narrow->columnWidth(LegendTableModel::Name), 40) << "names can be told apart";
    stack.setCursorsVisible(false);
    frame();
    EXPECT_FALSE(narrow->isColumnHidden(LegendTableModel::Value));
    stack.resize(1900, 900);
    for (int i = 0; i < 3; ++i) {
        frame();
    }
    EXPECT_TRUE(moved->geometry().contains(legendOf(shown(spec(4).quantity))->geometry()))
        << "in it where there is room";
}

TEST_F(PlotColumnsTest, whatTheUserDidToAPlotGoesAlong) {
    wheel(plots()[1], {100, 20}, 2, Qt::ControlModifier);
    Q_EMIT legends()[0]->toggleRequested(1);
    const ValueRange zoomed = stack.valueRange(1);
    stack.setOwnTime(1, OwnTime{3.0, true});
    ASSERT_TRUE(stack.movePlot(1, 1));
    frame();
    EXPECT_EQ(stack.valueRange(4), zoomed);
    ASSERT_TRUE(stack.ownTime(4));
    EXPECT_NEAR(stack.timeRange(4).length_s(), 3.0, 1e-9);
    EXPECT_FALSE(shown(spec(0).quantity)->curves()[1]->isVisible());
    EXPECT_FALSE(stack.ownTime(1));
}

TEST_F(PlotColumnsTest, aCurveGetsAPlotBesideByTheKeysOfItsLegend) {
    ASSERT_EQ(spec(0).curves.size(), 2U);
    const PlotSpec both = spec(0);
    pressIn(legendOf(shown(both.quantity)), Qt::Key_Right, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_EQ(stack.plots().size(), 6U);
    EXPECT_EQ(spec(5).column, 1);
    EXPECT_EQ(spec(5).curves, std::vector<PlotCurve>{both.curves[0]});
    EXPECT_EQ(spec(0).curves, std::vector<PlotCurve>{both.curves[1]});
    auto* legend = qobject_cast<LiveLegend*>(QApplication::focusWidget());
    ASSERT_NE(legend, nullptr);
    EXPECT_EQ(legend->currentIndex().row(), 0) << "keys go on with the curve";
    press(legend, Qt::Key_Right, Qt::ControlModifier | Qt::ShiftModifier); // alone in its column
    EXPECT_EQ(stack.plots().size(), 6U);
    press(legend, Qt::Key_Left, Qt::ControlModifier); // to the plot beside it, at the same height
    EXPECT_EQ(stack.plots().size(), 5U);
    EXPECT_EQ(spec(0).curves.size(), 2U);
    EXPECT_EQ(stack.columnCount(), 1);
}

TEST_F(PlotColumnsTest, aPlotOfOneCurveGoesBesideAsAWhole) {
    ASSERT_EQ(spec(1).curves.size(), 1U);
    const QString quantity = spec(1).quantity;
    ASSERT_TRUE(stack.separateBeside(1, spec(1).curves[0].signal));
    EXPECT_EQ(columns(), (std::vector<int>{0, 0, 0, 0, 1}));
    EXPECT_EQ(spec(4).quantity, quantity);
    EXPECT_FALSE(stack.separateBeside(4, spec(4).curves[0].signal));
    EXPECT_FALSE(stack.separateBeside(0, "no such"));
}

TEST_F(PlotColumnsTest, curvesMoveUpAndDownInTheirColumnOnly) {
    ASSERT_TRUE(stack.separateBeside(0, spec(0).curves[0].signal));
    frame();
    LiveLegend* alone = legendOf(shown(spec(5).quantity)); // two have the quantity: take the one at the right
    for (LivePlot* plot : plots()) {
        alone = plot->spec().column == 1 ? legendOf(plot) : alone;
    }
    pressIn(alone, Qt::Key_Up, Qt::ControlModifier);
    EXPECT_EQ(stack.plots().size(), 6U);
}

TEST_F(PlotColumnsTest, aSignalDroppedAtTheRightEdgeIsForAPlotBeside) {
    int beside = -5;
    int on = -5;
    QObject::connect(&stack, &LivePlotStack::signalsDroppedBeside, &stack,
                     [&](int plot, const QStringList&) { beside = plot; });
    QObject::connect(&stack, &LivePlotStack::signalsDropped, &stack,
                     [&](int plot, const QStringList&) { on = plot; });
    QMimeData data;
    data.setData(SignalsMimeType, "speed\n");
    LivePlot* plot = plots()[2];
    const QRect canvas = plot->canvasRect();
    const auto drop = [&](QPoint place) {
        QDragEnterEvent enter(place, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(plot, &enter);
        QDragMoveEvent move(place, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(plot, &move);
        EXPECT_TRUE(move.isAccepted());
        QDropEvent event(place, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(plot, &event);
    };
    drop(canvas.center());
    EXPECT_EQ(on, 2);
    EXPECT_EQ(beside, -5);
    drop({canvas.right() - 5, canvas.center().y()});
    EXPECT_EQ(beside, 2);
}

TEST_F(PlotColumnsTest, whereADropWillGoIsSeenWhileDragging) {
    LivePlot* plot = plots()[2];
    const QRect canvas = plot->canvasRect();
    QMimeData data;
    data.setData(SignalsMimeType, "speed\n");
    const auto seen = [&] { return plot->canvas()->grab().toImage(); };
    const QImage before = seen();
    QDragEnterEvent enter(canvas.center(), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(plot, &enter);
    QDragMoveEvent move(QPoint(canvas.right() - 5, canvas.center().y()), Qt::CopyAction, &data,
                        Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(plot, &move);
    QImage during = seen();
    EXPECT_NE(during, before);
    EXPECT_EQ(during.copy(0, 0, canvas.width() / 2, canvas.height()),
              before.copy(0, 0, canvas.width() / 2, canvas.height()))
        << "only the right edge";
    QDragLeaveEvent leave;
    QApplication::sendEvent(plot, &leave);
    EXPECT_EQ(seen(), before);
}

TEST_F(PlotColumnsTest, anEmptyPlotIsOpenedBesideAndGoesByKey) {
    plots()[1]->setFocus();
    trigger(LivePlotStack::Command::NewBeside);
    ASSERT_EQ(stack.plots().size(), 6U);
    EXPECT_EQ(spec(5).column, 1);
    auto* empty = qobject_cast<LivePlot*>(QApplication::focusWidget());
    ASSERT_NE(empty, nullptr);
    EXPECT_EQ(empty->accessibleName(), "Empty plot, column 2");
    EXPECT_EQ(legendOf(empty)->accessibleName(), "Live values of Empty plot, column 2");
    EXPECT_TRUE(shown(spec(0).quantity)->accessibleName().endsWith(", column 1"));
    trigger(LivePlotStack::Command::RemovePlot);
    EXPECT_EQ(stack.plots().size(), 5U);
    EXPECT_EQ(stack.columnCount(), 1);
    EXPECT_FALSE(plots()[0]->accessibleName().contains("column"));
    EXPECT_NE(qobject_cast<LivePlot*>(QApplication::focusWidget()), nullptr) << "keys go on with another";
    stack.clearFocus();
    QApplication::focusWidget()->clearFocus();
    trigger(LivePlotStack::Command::RemovePlot);
    EXPECT_EQ(stack.plots().size(), 5U) << "nobody said which one";
}

TEST_F(PlotColumnsTest, tabGoesDownAColumnThenToTheNextOne) {
    ASSERT_TRUE(stack.movePlot(0, 1));
    ASSERT_TRUE(stack.movePlot(2, -1)); // a column before the first
    frame();
    std::vector<const QWidget*> order;
    std::vector<const QWidget*> wanted;
    for (const PlotSpec& each : stack.plots()) {
        wanted.push_back(shown(each.quantity));
        wanted.push_back(legendOf(shown(each.quantity)));
    }
    const QWidget* widget = wanted.front();
    for (std::size_t i = 0; i < 1000 && order.size() < wanted.size(); ++i) {
        if (std::find(wanted.begin(), wanted.end(), widget) != wanted.end()) {
            order.push_back(widget);
        }
        widget = widget->nextInFocusChain();
    }
    EXPECT_EQ(order, wanted);
}

TEST_F(PlotColumnsTest, plotsAreSetInTheOrderOfTheirColumnsWithoutEmptyOnes) {
    std::vector<PlotSpec> specs = motorPlots();
    specs[0].column = 7;
    specs[3].column = 2;
    stack.setPlots(specs);
    frame();
    EXPECT_EQ(columns(), (std::vector<int>{0, 0, 0, 1, 2}));
    EXPECT_EQ(spec(4).quantity, motorPlots()[0].quantity);
    EXPECT_EQ(spec(3).quantity, motorPlots()[3].quantity);
    stack.addCurve(99, {"current", "Current", "A", 1.0, 3});
    EXPECT_EQ(columns().back(), 2) << "below the last";
}

} // namespace
} // namespace halbench::widgets
