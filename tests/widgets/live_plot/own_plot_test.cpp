// A curve that gets a plot of its own, by the keys of its legend.
#include "tests/widgets/live_plot/live_plot_stack_fixture.h"

namespace halbench::widgets {
namespace {

class OwnPlotTest : public LivePlotStackTest {
protected:
    void separate(int plot, int curve) {
        LiveLegend* legend = legends()[static_cast<std::size_t>(plot)];
        legend->setFocus();
        legend->setCurrentIndex(legend->model()->index(curve, 0));
        QKeyEvent press(QEvent::KeyPress, Qt::Key_Down, Qt::ControlModifier | Qt::ShiftModifier);
        QApplication::sendEvent(legend, &press);
        frame();
    }
    const PlotSpec& spec(std::size_t plot) const { return stack.plots()[plot]; }
};

TEST_F(OwnPlotTest, twoHallSensorsAreSeenInTwoPlots) {
    ASSERT_EQ(stack.plots().size(), 5U);
    ASSERT_EQ(spec(0).curves.size(), 2U);
    const PlotSpec both = spec(0);
    separate(0, 1);
    ASSERT_EQ(stack.plots().size(), 6U);
    EXPECT_EQ(spec(0).curves, std::vector<PlotCurve>{both.curves[0]});
    EXPECT_EQ(spec(1).curves, std::vector<PlotCurve>{both.curves[1]});
    EXPECT_EQ(spec(1).quantity, both.quantity);
    EXPECT_EQ(spec(1).unit, both.unit);
    EXPECT_EQ(plots().size(), 6U);
    EXPECT_EQ(legends()[1]->currentIndex().row(), 0) << "keys go on with the curve";
    separate(1, 0); // alone there already
    EXPECT_EQ(stack.plots().size(), 6U);
    EXPECT_TRUE(stack.moveCurve(1, spec(1).curves[0].signal, 0)); // and back
    EXPECT_EQ(stack.plots().size(), 5U);
}

TEST_F(OwnPlotTest, whatWasOnTheRightIsOnTheLeftThere) {
    ASSERT_TRUE(stack.moveCurve(2, "speed", 1));
    frame();
    const QString quantity = spec(1).right.quantity;
    separate(1, 1);
    ASSERT_EQ(spec(2).curves.size(), 1U);
    EXPECT_EQ(spec(2).curves[0].signal, "speed");
    EXPECT_FALSE(spec(2).curves[0].isRight);
    EXPECT_EQ(spec(2).quantity, quantity);
    EXPECT_EQ(spec(2).unit, "r/min");
    EXPECT_FALSE(hasRightAxis(spec(1)));
}

TEST_F(OwnPlotTest, limitBandsGoAlong) {
    ASSERT_FALSE(spec(4).bands.empty());
    ASSERT_EQ(spec(4).curves.size(), 2U); // two coils
    separate(4, 1);
    EXPECT_EQ(spec(5).bands, spec(4).bands);
}

TEST_F(OwnPlotTest, plotsBelowKeepTheirTimeAxes) {
    stack.setOwnTime(2, OwnTime{3.0, true});
    frame();
    separate(0, 1);
    EXPECT_FALSE(stack.ownTime(1));
    EXPECT_FALSE(stack.ownTime(2));
    ASSERT_TRUE(stack.ownTime(3));
    EXPECT_NEAR(stack.timeRange(3).length_s(), 3.0, 1e-9);
    EXPECT_GT(stack.timeRange(2).length_s(), 3.5);
}

} // namespace
} // namespace halbench::widgets
