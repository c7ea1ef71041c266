// Where a signal is seen that was dropped on a plot.
#include "app/workspaces/monitor/monitor_panel.h"
#include "tests/app/workspaces/bench_fixture.h"
#include "tests/app/workspaces/monitor/five_plots.h"
#include "widgets/live_plot/live_plot_stack.h"

#include <set>

namespace halbench::app {
namespace {

class MonitorDropTest : public BenchTest {
protected:
    void SetUp() override {
        BenchTest::SetUp();
        panel = std::make_unique<MonitorPanel>(bench());
        panel->setView(fivePlots());
        panel->resize(1200, 800);
        panel->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(panel.get()));
        connectTo("sim:htm", 5.0);
        ASSERT_EQ(stack().plots().size(), 5U);
    }
    void TearDown() override { panel.reset(); }

    widgets::LivePlotStack& stack() { return *panel->findChild<widgets::LivePlotStack*>(); }
    void drop(int plot, const char* signal) { Q_EMIT stack().signalsDropped(plot, {signal}); }
    std::multiset<std::string> signalsOf(std::size_t plot) {
        std::multiset<std::string> signals;
        for (const widgets::PlotCurve& curve : stack().plots()[plot].curves) {
            signals.insert(curve.signal);
        }
        return signals;
    }

    std::unique_ptr<MonitorPanel> panel;
};

TEST_F(MonitorDropTest, isThatPlotWhereItsQuantityIsAlready) {
    drop(2, "truth.speed");
    EXPECT_EQ(signalsOf(2), (std::multiset<std::string>{"speed", "truth.speed"}));
    EXPECT_FALSE(stack().plots()[2].curves.back().isRight);
}

TEST_F(MonitorDropTest, isItsRightAxisForAnotherUnit) {
    drop(0, "truth.speed"); // onto the Hall sensors
    ASSERT_EQ(stack().plots().size(), 5U);
    EXPECT_EQ(signalsOf(0), (std::multiset<std::string>{"hall.a", "hall.b", "truth.speed"}));
    EXPECT_TRUE(stack().plots()[0].curves.back().isRight);
    EXPECT_EQ(stack().plots()[0].right.unit, "r/min");
    EXPECT_EQ(signalsOf(2).count("truth.speed"), 0U);
}

TEST_F(MonitorDropTest, isAPlotBelowWhereBothAxesHaveOthers) {
    drop(0, "truth.speed");
    drop(0, "truth.position");
    ASSERT_EQ(stack().plots().size(), 6U);
    EXPECT_EQ(signalsOf(1), (std::multiset<std::string>{"truth.position"}));
    EXPECT_EQ(signalsOf(2).count("position"), 1U) << "the others went down";
}

TEST_F(MonitorDropTest, isAPlotBesideAtTheRightEdge) {
    Q_EMIT stack().signalsDroppedBeside(2, {"truth.speed", "truth.position"});
    ASSERT_EQ(stack().plots().size(), 6U);
    EXPECT_EQ(signalsOf(5), (std::multiset<std::string>{"truth.speed", "truth.position"}));
    EXPECT_EQ(stack().plots()[5].column, 1);
    panel->plot("truth.current_command", true); // joins its unit or comes below the last
    for (const widgets::PlotSpec& plot : stack().plots()) {
        EXPECT_LE(plot.column, 1);
    }
}

TEST_F(MonitorDropTest, isInTheEmptyPlotThatWasOpenedForIt) {
    stack().openBeside(0, {});
    panel->plot("truth.speed", true);
    EXPECT_EQ(signalsOf(5), (std::multiset<std::string>{"truth.speed"}));
    EXPECT_EQ(stack().plots()[5].column, 1) << "the plot stays where it was opened";
}

TEST_F(MonitorDropTest, isNothingNewForWhatIsThere) {
    drop(2, "speed");
    drop(0, "truth.speed");
    drop(0, "truth.speed");
    EXPECT_EQ(signalsOf(2), (std::multiset<std::string>{"speed"}));
    EXPECT_EQ(signalsOf(0).count("truth.speed"), 1U);
    EXPECT_EQ(stack().plots().size(), 5U);
}

} // namespace
} // namespace halbench::app
