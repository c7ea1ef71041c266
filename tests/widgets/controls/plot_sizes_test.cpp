// How plots share the room of their stack.
#include "tests/widgets/dragged_handle.h"
#include "tests/widgets/live_plot/live_plot_stack_fixture.h"
#include "widgets/controls/share_splitter.h"

namespace halbench::widgets {
namespace {

using Command = LivePlotStack::Command;

class PlotSizesTest : public LivePlotStackTest {
protected:
    ShareSplitter& columns() { return *stack.findChild<ShareSplitter*>(); }
    ShareSplitter& rows(int column) { return *columns().widget(column)->findChild<ShareSplitter*>(); }
    void drag(const ShareSplitter& splitter, int line, int by_px) {
        dragHandle(splitter, line, by_px);
        frame();
    }
    const PlotSpec& spec(std::size_t plot) const { return stack.plots()[plot]; }
    std::vector<double> heights() const {
        std::vector<double> list;
        for (const PlotSpec& plot : stack.plots()) {
            list.push_back(plot.height_ratio);
        }
        return list;
    }
    double sizeRatio(const ShareSplitter& splitter, int one, int other) {
        return static_cast<double>(splitter.sizes()[one]) / splitter.sizes()[other];
    }
};

TEST_F(PlotSizesTest, aDraggedLineIsInTheDescriptionOfThePlots) {
    drag(rows(0), 1, 60);
    EXPECT_GT(spec(0).height_ratio, 1.2);
    EXPECT_LT(spec(1).height_ratio, 0.8);
    EXPECT_NEAR(spec(2).height_ratio, 1.0, 0.02) << "the others stay";
    EXPECT_NEAR(sizeRatio(rows(0), 0, 1), spec(0).height_ratio / spec(1).height_ratio, 0.02);
    ASSERT_TRUE(stack.movePlot(0, 1));
    frame();
    drag(columns(), 1, -200);
    EXPECT_GT(spec(4).width_ratio, 1.25);
    EXPECT_EQ(spec(0).width_ratio, spec(3).width_ratio) << "all of a column say it";
    EXPECT_NEAR(spec(0).width_ratio + spec(4).width_ratio, 2.0, 0.02); // the mean is 1, each to a hundredth
}

TEST_F(PlotSizesTest, whatIsSetIsShownAndStaysToTheDigitWhateverTheWindowDoes) {
    std::vector<PlotSpec> plots = stack.plots();
    plots[0].height_ratio = 1.731;
    plots[1].height_ratio = 0.567;
    plots[3].column = 1;
    plots[4].column = 1;
    plots[3].width_ratio = 0.619;
    stack.setPlots(plots);
    for (const QSize size : {QSize(1200, 900), QSize(640, 480), QSize(1333, 777), QSize(1200, 900)}) {
        stack.resize(size);
        frame();
    }
    EXPECT_NEAR(sizeRatio(rows(0), 0, 1), 1.731 / 0.567, 0.03); // of some 150 px, to the pixel
    EXPECT_NEAR(sizeRatio(columns(), 1, 0), 0.619, 0.005);
    EXPECT_EQ(heights(), (std::vector<double>{1.731, 0.567, 1.0, 1.0, 1.0}));
    EXPECT_EQ(spec(4).width_ratio, 0.619);
}

TEST_F(PlotSizesTest, onesThatComeAndGoLeaveTheOthersTheirProportions) {
    std::vector<PlotSpec> plots = stack.plots();
    plots[0].height_ratio = 2.0;
    plots[1].height_ratio = 0.5;
    plots[2].height_ratio = 0.5;
    stack.setPlots(plots);
    frame();
    stack.openPlot(3, {});
    frame();
    EXPECT_EQ(heights(), (std::vector<double>{2.0, 0.5, 0.5, 1.0, 1.0, 1.0})) << "as high as the mean";
    EXPECT_NEAR(sizeRatio(rows(0), 0, 1), 4.0, 0.2);
    stack.removePlot(1);
    frame();
    EXPECT_NEAR(spec(0).height_ratio / spec(1).height_ratio, 4.0, 0.1); // each to a hundredth
    EXPECT_NEAR(sizeRatio(rows(0), 0, 1), 4.0, 0.2);
    ASSERT_TRUE(stack.movePlot(0, 1));
    EXPECT_EQ(stack.plots().back().height_ratio, 1.0) << "alone in its column";
}

TEST_F(PlotSizesTest, plotsGetTallerAndColumnsWiderByKey) {
    ASSERT_TRUE(stack.movePlot(4, 1));
    frame();
    LivePlot* second = rows(0).widget(1)->findChild<LivePlot*>();
    second->setFocus();
    const int height = second->height();
    const int width = columns().sizes()[0];
    trigger(Command::Taller);
    EXPECT_GT(second->height(), height + 10);
    EXPECT_GT(spec(1).height_ratio, 1.1);
    trigger(Command::Wider);
    EXPECT_GT(columns().sizes()[0], width + 20);
    EXPECT_GT(spec(0).width_ratio, 1.05);
    trigger(Command::Shorter);
    trigger(Command::Narrower);
    EXPECT_NEAR(second->height(), height, 4); // whole pixels on the way
    EXPECT_NEAR(columns().sizes()[0], width, 4);
    trigger(Command::Taller);
    trigger(Command::Wider);
    trigger(Command::EqualSizes);
    EXPECT_EQ(heights(), (std::vector<double>{1.0, 1.0, 1.0, 1.0, 1.0}));
    EXPECT_EQ(spec(0).width_ratio, 1.0);
    EXPECT_NEAR(second->height(), height, 1);
    EXPECT_TRUE(second->hasFocus());
}

TEST_F(PlotSizesTest, otherRoomChangesNothingElseOfAPlot) {
    wheel(plots()[1], {100, 20}, 2, Qt::ControlModifier);
    Q_EMIT legends()[0]->toggleRequested(1);
    const ValueRange zoomed = stack.valueRange(1);
    drag(rows(0), 1, 60);
    const std::vector<double> dragged = heights();
    stack.setPlots(stack.plots()); // as other units do
    stack.addCurve(2, {"current", "Current", "A", 1.0, 3});
    frame();
    EXPECT_EQ(heights(), dragged);
    EXPECT_EQ(stack.valueRange(1), zoomed);
    EXPECT_FALSE(plots()[0]->curves()[1]->isVisible());
}

} // namespace
} // namespace halbench::widgets
